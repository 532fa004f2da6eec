// Stamps of the device's clock that cannot be true become no times.
#include "gl/timer.h"

#include "support/catch.h"

using ballpit::gl::elapsed_ns;

TEST_CASE("time goes on between two stamps", "[timer]") {
    constexpr std::uint64_t now = 1'763'813'000'000'000'000;  // ns since 1970, as one driver counts
    CHECK(elapsed_ns(now, now + 1500, 64) == 1500u);
    CHECK(elapsed_ns(now, now, 64) == 0u);
    CHECK(elapsed_ns(1, 3'000'000'001, 64) == 3'000'000'000u);
}

TEST_CASE("a stamp of nothing, or before the one that it follows, is no time", "[timer]") {
    constexpr std::uint64_t now = 1'763'813'000'000'000'000;
    CHECK_FALSE(elapsed_ns(now, 0, 64));  // would be 1.67e13 ms
    CHECK_FALSE(elapsed_ns(0, now, 64));  // would be 1.76e12 ms
    CHECK_FALSE(elapsed_ns(0, 0, 64));
    CHECK_FALSE(elapsed_ns(now, now - 1, 64));
    CHECK_FALSE(elapsed_ns(now, now + 1, 0));  // no such clock
}

TEST_CASE("a counter of few bits that begins anew has gone on", "[timer]") {
    constexpr std::uint64_t full = std::uint64_t{1} << 36;
    CHECK(elapsed_ns(full - 100, 50, 36) == 150u);
    CHECK(elapsed_ns(100, 1'000'000'100, 36) == 1'000'000'000u);
    CHECK_FALSE(elapsed_ns(200, 100, 36));
    CHECK_FALSE(elapsed_ns(full - 100, 50, 64));
}
