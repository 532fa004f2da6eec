#include "ui/live_check.h"

#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

bool beyond(const StageCheck& check) { return check.ran && check.beyond_bound > 0; }

bool red_before(const LiveCheckState& state, Stage stage) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(stage); ++i) {
        if (state.stages[i].ran && (beyond(state.stages[i]) || state.stages[i].violation)) {
            return true;
        }
    }
    return false;
}

std::string sentence(const StageCheck& check) {
    return grouped(check.differing) + (check.differing == 1 ? " differs" : " differ") + ", first: " + check.first + ".";
}

Badge compared_badge(const StageCheck& check) {
    if (check.differing == 0) {
        return {Badge::Kind::same, "0 of " + grouped(check.elements) + " differ", ""};
    }
    return {Badge::Kind::within, format("max %s ULP", grouped(check.max_ulp).c_str()),
            sentence(check) + format(" Rounding explains it: at most %.2g %% of the bound.", 100.0 * check.of_bound)};
}

}  // namespace

std::string_view stage_promise(Stage stage) {
    switch (stage) {
        case Stage::assign_cells:
            return "every cell id inside the grid";
        case Stage::bitonic_sort:
        case Stage::counting_sort:
            return "sorted, a permutation";
        case Stage::build_grid:
            return "ranges partition the slots";
        case Stage::collide:
            return "no NaN, momentum balanced";
    }
    return "";
}

Badge stage_badge(const LiveCheckState& state, Stage stage) {
    const StageCheck& check = state.stages[static_cast<std::size_t>(stage)];
    if (state.mode == LiveCheckMode::off || !check.ran) {
        return {};
    }
    const bool follows = red_before(state, stage);
    if (beyond(check) && follows) {
        return {Badge::Kind::not_judged,
                grouped(check.beyond_bound) + (check.beyond_bound == 1 ? " differs" : " differ"),
                "An earlier stage is red: what is wrong there may show here, too. " + sentence(check)};
    }
    if (beyond(check)) {
        return {Badge::Kind::differs, grouped(check.beyond_bound) + (check.beyond_bound == 1 ? " differs" : " differ"),
                sentence(check)};
    }
    if (check.violation && follows) {
        return {Badge::Kind::not_judged, "not judged", "An earlier stage left something broken for this one to read."};
    }
    if (check.violation) {
        return {Badge::Kind::differs, "promise broken",
                "Promised: " + std::string(stage_promise(stage)) + ". " + *check.violation + "."};
    }
    if (check.compared) {
        return compared_badge(check);
    }
    return {Badge::Kind::same, "promise kept", "Kept: " + std::string(stage_promise(stage)) + "."};
}

}  // namespace ballpit::ui
