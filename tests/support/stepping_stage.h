// Strip and microscope at a place of a substep, without a run.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "ui/state.h"

namespace ballpit::test {

inline Features contacts() {
    Features features;
    features.add(Feature::contact);
    return features;
}

inline Schedule schedule_of(std::uint32_t balls) {
    const Grid grid = make_grid(dvec3(4.0), 0.2, 1.0, balls);
    return make_schedule(balls, grid, contacts(), SortMethod::bitonic);
}

inline vec3 grey(std::uint32_t) { return vec3(0.5f); }
inline vec3 grey_amount(float amount) { return vec3(amount); }

/// A state with the strip open, at a place.
struct StripStage {
    Schedule schedule = schedule_of(200);
    ui::SteppingState stepping;
    ui::Inspection inspection;
    std::vector<Key> keys;
    std::vector<Key> before;
    std::array<ui::SceneChoice, 1> scenes{{{"Rain", "Balls fall."}}};
    ui::State state;

    explicit StripStage(std::uint32_t ran) {
        stepping.schedule = &schedule;
        stepping.substeps = 4;
        stepping.place = {{11, 1}, ran};
        stepping.furthest_step = 20;
        stepping.hash_step = 11;
        stepping.checkpoint_budget = std::size_t{256} << 20;
        state.scenes = scenes;
        state.amount_colour = grey_amount;
        state.which_colour = grey;
        state.stepping = &stepping;
        state.inspection = &inspection;
        state.view.stepper = true;
        for (std::uint32_t i = 0; i < schedule.key_count; ++i) {
            const std::uint32_t cell = (i * 37) % 200;
            before.push_back(i < 200 ? Key{cell, i} : Key{SENTINEL, SENTINEL});
        }
        keys = before;
        inspection.slots[static_cast<std::size_t>(Slot::keys)].bytes = std::as_bytes(std::span(keys));
        inspection.keys_before = std::as_bytes(std::span(before));
    }
};

}  // namespace ballpit::test
