// The laws that a scene declares: what it models. A law that is off is not computed, not stored, not bound.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace ballpit {

struct Laws {
    bool gravity = false;
    bool drag = false;
    bool contact = false;
    bool restitution = false;
    bool walls = false;
    bool shake = false;
    // The next three hold wherever the balls of a scene differ in it; set, they hold for equal balls, too, which
    // changes no bit of the result but shows what they cost.
    bool unequal_radii = false;
    bool unequal_masses = false;
    bool ball_restitution = false;
    bool diagnostics = true;
    bool compensated = false;

    friend bool operator==(const Laws&, const Laws&) = default;
};

struct LawInfo {
    std::string_view key;    // as in --set laws=
    std::string_view label;  // as on the panel
    bool Laws::*member;
    std::string_view about;  // what it changes, one sentence
    std::string_view price;  // what it asks for beyond arithmetic
};

inline constexpr std::size_t law_count = 11;

/// Every law, in the order of the panel.
std::span<const LawInfo, law_count> law_table();

/// "gravity,contact,walls" or "none", in the order of the table.
std::string laws_text(const Laws& laws);

/// The laws of such a list. Throws InputError (the name, and those there are).
Laws parse_laws(std::string_view text);

}  // namespace ballpit
