// The views into a scene without a window: a session to look into, and what the window does with its views in a frame.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "app/window_views.h"
#include "support/catch.h"
#include "support/scenes.h"

namespace ballpit::test {

/// On the mirror, with a grid: there are cells to look into, also where balls are few.
inline app::Session inspected_session(std::string_view scene, std::uint32_t balls, std::uint32_t substeps = 2) {
    app::WindowOptions options;
    options.scene = shipped_scene(scene);
    options.scene_file = std::string(scene);
    options.settings = options.scene.settings;
    options.settings.balls = balls;
    options.settings.substeps = substeps;
    options.settings.neighbours = NeighbourSearch::grid;
    options.seed = seed_of(options.scene);
    options.backend = "cpu";
    return app::Session(options, false, "");
}

/// One frame of the views, as the window runs them.
struct Loop {
    app::Session session;
    app::Inspector inspector;
    app::Views views;
    ui::Inspection inspection;
    ui::ViewOptions view;
    ui::ProbeState state;
    double now_s = 0.0;

    explicit Loop(app::Session made) : session(std::move(made)) {}

    void frame(bool running = false) {
        now_s += 0.5;
        if (views.needs_cells(view, inspection)) {
            session.prepare_cells();
        }
        if (running) {
            session.step();
        }
        views.want(inspector, view, inspection);
        inspector.update(session, running, now_s);
        inspector.describe(inspection, now_s);
        views.update(session, inspector, inspection, view, {}, running, now_s);
        views.describe(state, session, inspection, view, 8);
    }
    void act(ui::Action action) { REQUIRE(views.act(action, inspection, session)); }
};

inline bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

inline vec3 grey(float amount) { return vec3(amount); }

/// What panels are told that look into a scene.
struct Screen {
    std::array<ui::SceneChoice, 1> scenes{{{"Rain", "Balls fall."}}};
    ui::State state;

    explicit Screen(const ui::ProbeState& probe) {
        state.scenes = scenes;
        state.amount_colour = grey;
        state.probe = &probe;
    }
};

}  // namespace ballpit::test
