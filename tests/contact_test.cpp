// The contact law's map between restitution and damping ratio, against the closed forms of A7, A8 and A8b.
#include "core/contact.h"

#include <array>
#include <cmath>

#include "support/catch.h"

using namespace ballpit;

namespace {

struct ForwardRow {
    double zeta, unlimited, limited;
};

struct InverseRow {
    double e, unlimited, limited;
};

}  // namespace

TEST_CASE("a damping ratio gives the restitution of the closed forms", "[core]") {
    constexpr std::array<ForwardRow, 5> rows = {{{.05, 0.85446789, 0.8587581},
                                                 {.1, 0.72924761, 0.7440794},
                                                 {.2, 0.5266206, 0.57174003},
                                                 {.3, 0.3723261, 0.45097545},
                                                 {.5, 0.16303353, 0.29843606}}};
    for (const auto& row : rows) {
        CAPTURE(row.zeta);
        CHECK(restitution_from_damping_ratio(row.zeta, false) == Approx(row.unlimited).epsilon(1e-7));
        CHECK(restitution_from_damping_ratio(row.zeta, true) == Approx(row.limited).epsilon(1e-7));
    }
    CHECK(restitution_from_damping_ratio(std::sqrt(0.5), true) == Approx(0.20787958).epsilon(1e-7));
    CHECK(restitution_from_damping_ratio(0.9, true) == Approx(0.15528275).epsilon(1e-7));
}

TEST_CASE("a restitution gives the damping ratio of the closed forms", "[core]") {
    constexpr std::array<InverseRow, 6> rows = {{{.9, 0.03351844911, 0.03426520413},
                                                 {.8, 0.0708503002, 0.0743550971},
                                                 {.7, 0.1128084507, 0.1222147478},
                                                 {.6, 0.1604930467, 0.1808583084},
                                                 {.5, 0.215453762, 0.2552756376},
                                                 {.3, 0.3578571305, 0.4972393947}}};
    for (const auto& row : rows) {
        CAPTURE(row.e);
        CHECK(damping_ratio_from_restitution(row.e, false) == Approx(row.unlimited).epsilon(1e-8));
        CHECK(damping_ratio_from_restitution(row.e, true) == Approx(row.limited).epsilon(1e-8));
    }
}

TEST_CASE("restitution and damping ratio invert each other over the whole range", "[core]") {
    for (const bool limit_force : {false, true}) {
        double previous = 1e9;
        for (int i = 0; i <= 95; ++i) {
            const double e = minimum_restitution + 0.01 * i;
            const double zeta = damping_ratio_from_restitution(e, limit_force);
            CAPTURE(limit_force, e, zeta);
            CHECK(zeta < previous);  // more bounce, less damping
            CHECK(restitution_from_damping_ratio(zeta, limit_force) == Approx(e).epsilon(1e-12));
            previous = zeta;
        }
    }
}

TEST_CASE("no loss means no dashpot", "[core]") {
    for (const bool limit_force : {false, true}) {
        CHECK(damping_ratio_from_restitution(1.0, limit_force) == 0.0);
        CHECK(restitution_from_damping_ratio(0.0, limit_force) == 1.0);
    }
}

TEST_CASE("the limited restitution has no seam where the dashpot becomes overcritical", "[core]") {
    CHECK(restitution_from_damping_ratio(1.0, true) == Approx(std::exp(-2.0)).epsilon(1e-14));
    CHECK(restitution_from_damping_ratio(1.0 - 1e-7, true) == Approx(std::exp(-2.0)).epsilon(1e-6));
    CHECK(restitution_from_damping_ratio(1.0 + 1e-7, true) == Approx(std::exp(-2.0)).epsilon(1e-6));
    CHECK(restitution_from_damping_ratio(1.5, false) == 0.0);
}
