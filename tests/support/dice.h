// The random numbers of one case of a fuzz: the n-th number of a case is the same on every machine.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/random.h"

namespace ballpit::test {

class Dice {
public:
    Dice(std::uint64_t seed, std::uint64_t number) : seed_(seed), number_(number) {}

    double unit() { return random_unit(seed_, number_, next_++); }
    bool chance(double share) { return unit() < share; }
    std::size_t below(std::size_t count) {
        return std::min(count - 1, static_cast<std::size_t>(unit() * static_cast<double>(count)));
    }
    double between(double low, double high) { return low + (high - low) * unit(); }
    /// Uniform in the logarithm: every decade as likely as another.
    double decades(double low, double high) { return low * std::pow(high / low, unit()); }
    template <class List>
    const auto& one_of(const List& list) {
        return list[below(list.size())];
    }

private:
    std::uint64_t seed_;
    std::uint64_t number_;
    std::uint64_t next_ = 0;
};

}  // namespace ballpit::test
