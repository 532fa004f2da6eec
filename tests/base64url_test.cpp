// The envelope of share codes: bytes as letters, and bytes as fewer bytes.
#include "app/base64url.h"

#include "core/random.h"
#include "support/catch.h"
#include "view/stb.h"

using namespace ballpit;
using namespace ballpit::app;

namespace {

std::vector<unsigned char> bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

std::string random_text(std::uint64_t seed, std::size_t size, double letters) {
    std::string text;
    for (std::size_t i = 0; i < size; ++i) {
        text += static_cast<char>(static_cast<unsigned char>(letters * random_unit(seed, 0, i)));
    }
    return text;
}

constexpr std::size_t mebibyte = std::size_t{1} << 20;

}  // namespace

TEST_CASE("base64url has the letters of RFC 4648 and no padding", "[share]") {
    // The vectors of its section 10, and the two letters that differ from plain base64.
    CHECK(base64url(bytes_of("")).empty());
    CHECK(base64url(bytes_of("f")) == "Zg");
    CHECK(base64url(bytes_of("fo")) == "Zm8");
    CHECK(base64url(bytes_of("foo")) == "Zm9v");
    CHECK(base64url(bytes_of("foobar")) == "Zm9vYmFy");
    CHECK(base64url({0xFB, 0xFF}) == "-_8");
}

TEST_CASE("base64url comes back as it was, and nothing else is taken", "[share]") {
    for (std::size_t size = 0; size < 70; ++size) {
        const auto bytes = bytes_of(random_text(size, size, 256.0));
        CHECK(parse_base64url(base64url(bytes)) == bytes);
    }
    for (const char* bad : {"Z", "Zg=", "Zg==", "Zm9v!", "Zm 9", "Zh", "+_8", "Zm9vY"}) {
        CAPTURE(bad);
        CHECK_FALSE(parse_base64url(bad));
    }
}

TEST_CASE("packed bytes come back, and damaged ones do not", "[share]") {
    for (const std::size_t size : {1u, 3u, 1000u, 40000u}) {
        for (const double letters : {1.0, 4.0, 256.0}) {
            const std::string text = random_text(size, size, letters);
            const auto packed = view::stb::deflate(text);
            CHECK(view::stb::inflate(packed, mebibyte) == text);
        }
    }
    const std::string text = random_text(7, 500, 16.0);
    const auto packed = view::stb::deflate(text);
    for (std::size_t i = 0; i < packed.size(); ++i) {
        auto damaged = packed;
        damaged[i] ^= 0x10u;
        CHECK(view::stb::inflate(damaged, mebibyte).value_or(text) == text);
        CHECK_FALSE(view::stb::inflate(std::span(packed).first(i), mebibyte));
    }
}

TEST_CASE("packed bytes that unfold to more than is allowed are refused", "[share]") {
    const auto packed = view::stb::deflate(std::string(mebibyte, 'a'));
    CHECK(packed.size() < 16384);
    CHECK(view::stb::inflate(packed, mebibyte));
    CHECK_FALSE(view::stb::inflate(packed, mebibyte - 1));
}
