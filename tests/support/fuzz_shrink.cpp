#include "support/fuzz_shrink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/scene_file.h"
#include "core/world.h"

namespace ballpit::test {

namespace {

using Simpler = std::function<void(FuzzCase&)>;

bool is_scene(const FuzzCase& fuzz_case) {
    try {
        parse_case(case_text(fuzz_case), "case.json");
        return true;
    } catch (const InputError&) {
        return false;
    }
}

void set_balls(FuzzCase& fuzz_case) {
    const Scene& scene = fuzz_case.scene;
    fuzz_case.scene.settings.balls =
        static_cast<std::uint32_t>(scene.balls.size()) + (scene.fill ? scene.fill->count : 0u);
}

// The balls of the fill, one by one, so that they can be taken away.
void list_fill(FuzzCase& fuzz_case) {
    Scene& scene = fuzz_case.scene;
    if (!scene.fill) {
        return;
    }
    const World world = make_world(scene, scene.settings.balls, fuzz_case.seed);
    for (std::size_t i = scene.balls.size(); i < world.balls.positions.size(); ++i) {
        const vec4& position = world.balls.positions[i];
        const vec4& velocity = world.balls.velocities[i];
        scene.balls.push_back({dvec3(position), dvec3(velocity), static_cast<double>(position.w),
                               static_cast<double>(velocity.w), std::nullopt});
    }
    scene.fill.reset();
    set_balls(fuzz_case);
}

double rounder(double value) {
    if (value == 0.0 || !std::isfinite(value)) {
        return value;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))));
    return std::round(value / unit) * unit;
}

class Shrinker {
public:
    Shrinker(FuzzCase fuzz_case, const std::function<bool(const FuzzCase&)>& fails, int tries)
        : case_(std::move(fuzz_case)), fails_(fails), tries_(tries) {}

    FuzzCase run() {
        attempt(list_fill);
        for (bool smaller = true; smaller && tries_ > 0;) {
            smaller = false;
            smaller |= fewer_actions();
            smaller |= fewer_substeps();
            smaller |= fewer_balls();
            smaller |= fewer_laws();
            smaller |= usual_settings();
            smaller |= rounder_numbers();
        }
        return case_;
    }

private:
    /// Keeps the change if it is one, is a scene, and still fails.
    bool attempt(const Simpler& simplify) {
        FuzzCase simpler = case_;
        simplify(simpler);
        if (tries_ <= 0 || case_text(simpler) == case_text(case_)) {
            return false;
        }
        --tries_;
        if (!is_scene(simpler) || !fails_(simpler)) {
            return false;
        }
        case_ = std::move(simpler);
        return true;
    }

    bool fewer_actions() {
        bool any = false;
        for (std::size_t i = case_.actions.size(); i-- > 0;) {
            any |= attempt([i](FuzzCase& c) { c.actions.erase(c.actions.begin() + static_cast<std::ptrdiff_t>(i)); });
        }
        for (std::size_t i = 0; i < case_.actions.size(); ++i) {
            any |= attempt([i](FuzzCase& c) { c.actions[i].at = i == 0 ? 0 : c.actions[i - 1].at; });
        }
        return any;
    }

    bool fewer_substeps() {
        bool any = false;
        while (case_.substeps > 1 && attempt([](FuzzCase& c) { c.substeps /= 2; })) {
            any = true;
        }
        while (case_.substeps > 1 && attempt([](FuzzCase& c) { --c.substeps; })) {
            any = true;
        }
        return any;
    }

    // Halves, quarters … single balls, from the back.
    bool fewer_balls() {
        bool any = false;
        for (std::size_t length = std::max<std::size_t>(1, case_.scene.balls.size() / 2); length > 0; length /= 2) {
            for (std::size_t end = case_.scene.balls.size(); end >= length && end > 0;) {
                const std::size_t first = end - length;
                any |= attempt([first, length](FuzzCase& c) {
                    const auto begin = c.scene.balls.begin() + static_cast<std::ptrdiff_t>(first);
                    c.scene.balls.erase(begin, begin + static_cast<std::ptrdiff_t>(length));
                    set_balls(c);
                });
                end = std::min(first, case_.scene.balls.size());
            }
        }
        return any;
    }

    bool fewer_laws() {
        bool any = attempt([](FuzzCase& c) { c.scene.resume.reset(); });
        for (const LawInfo& law : law_table()) {
            any |= law.member != &Laws::diagnostics &&
                   attempt([&](FuzzCase& c) { c.scene.settings.laws.*law.member = false; });
        }
        return any;
    }

    bool usual_settings() {
        bool any = false;
        for (const SettingInfo& info : setting_table()) {
            any |= info.key != "balls" && info.key != "laws" && attempt([&](FuzzCase& c) {
                       assign_setting(c.scene.settings, info.key, setting_text(info, Settings{}));
                   });
        }
        return any;
    }

    bool rounder_numbers() {
        bool any = attempt([](FuzzCase& c) { c.scene.half_extent = dvec3(1.0); });
        any |= attempt([](FuzzCase& c) { c.seed = 1; });
        for (double* (*number)(Settings&) : std::array<double* (*)(Settings&), 4>{
                 [](Settings& s) { return &s.stiffness; }, [](Settings& s) { return &s.dt; },
                 [](Settings& s) { return &s.drag; }, [](Settings& s) { return &s.restitution; }}) {
            any |= attempt([&](FuzzCase& c) { *number(c.scene.settings) = rounder(*number(c.scene.settings)); });
        }
        for (int axis = 0; axis < 3; ++axis) {
            any |= attempt([&](FuzzCase& c) { c.scene.half_extent[axis] = rounder(c.scene.half_extent[axis]); });
        }
        for (std::size_t i = 0; i < std::min<std::size_t>(case_.scene.balls.size(), 8); ++i) {
            any |= rounder_ball(i);
        }
        return any;
    }

    bool rounder_ball(std::size_t i) {
        bool any = attempt([i](FuzzCase& c) { c.scene.balls[i].restitution.reset(); });
        any |= attempt([i](FuzzCase& c) { c.scene.balls[i].compensation.reset(); });
        any |= attempt([i](FuzzCase& c) { c.scene.balls[i].velocity = dvec3(0.0); });
        any |= attempt([i](FuzzCase& c) { c.scene.balls[i].mass = 1.0; });
        any |= attempt([i](FuzzCase& c) { c.scene.balls[i].radius = rounder(c.scene.balls[i].radius); });
        any |= attempt([i](FuzzCase& c) { c.scene.balls[i].mass = rounder(c.scene.balls[i].mass); });
        for (int axis = 0; axis < 3; ++axis) {
            for (dvec3 BallSpec::*vector : {&BallSpec::position, &BallSpec::velocity}) {
                any |= attempt([&](FuzzCase& c) { (c.scene.balls[i].*vector)[axis] = 0.0; });
                any |= attempt(
                    [&](FuzzCase& c) { (c.scene.balls[i].*vector)[axis] = rounder((c.scene.balls[i].*vector)[axis]); });
            }
        }
        return any;
    }

    FuzzCase case_;
    const std::function<bool(const FuzzCase&)>& fails_;
    int tries_;
};

}  // namespace

FuzzCase shrunk(FuzzCase fuzz_case, const std::function<bool(const FuzzCase&)>& fails, int tries) {
    return Shrinker(std::move(fuzz_case), fails, tries).run();
}

}  // namespace ballpit::test
