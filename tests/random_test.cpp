// Counter-based random numbers: the same everywhere, independent of each other, uniform.
#include "core/random.h"

#include <array>
#include <cmath>
#include <set>

#include "support/catch.h"

using namespace ballpit;

TEST_CASE("mix_bits is the output function of SplitMix64", "[core]") {
    // The first two outputs of the published generator with seed 0: the state advances by the golden gamma.
    constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ull;
    CHECK(mix_bits(golden) == 0xE220A8397B1DCDAFull);
    CHECK(mix_bits(2 * golden) == 0x6E789E6AA1B965F4ull);
}

TEST_CASE("numbers are uniform in [0, 1) in each stream", "[core]") {
    constexpr int count = 100000;
    constexpr int bins = 20;
    for (std::uint64_t stream = 0; stream < 4; ++stream) {
        std::array<int, bins> histogram{};
        double neighbours = 0.0;  // correlation of consecutive indices
        for (std::uint64_t i = 0; i < count; ++i) {
            const double u = random_unit(42, stream, i);
            REQUIRE((u >= 0.0 && u < 1.0));
            ++histogram[static_cast<std::size_t>(u * bins)];
            neighbours += (u - 0.5) * (random_unit(42, stream, i + 1) - 0.5);
        }
        double chi_squared = 0.0;
        for (const int entries : histogram) {
            const double expected = static_cast<double>(count) / bins;
            chi_squared += (entries - expected) * (entries - expected) / expected;
        }
        CAPTURE(stream, chi_squared);
        CHECK(chi_squared < 43.8);  // 19 degrees of freedom: exceeded by chance once in a thousand
        CHECK(std::abs(neighbours / count) < 4.0 / 12.0 / std::sqrt(static_cast<double>(count)));
    }
}

TEST_CASE("seed, stream and index all matter", "[core]") {
    std::set<double> seen;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        for (std::uint64_t stream = 0; stream < 10; ++stream) {
            for (std::uint64_t index = 0; index < 10; ++index) {
                seen.insert(random_unit(seed, stream, index));
            }
        }
    }
    CHECK(seen.size() == 1000);
}
