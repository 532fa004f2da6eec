#include "app/probe_sample.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "cpu/assign_cells.h"

namespace ballpit::app {

namespace {

template <class T>
std::vector<T> elements(const Bytes* bytes) {
    return bytes == nullptr ? std::vector<T>() : typed<T>(*bytes);
}

bool same(const std::vector<vec4>& a, const std::vector<vec4>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(vec4)) == 0);
}

// Whether every ball lies in the cell that its key names.
bool made_from(const std::vector<Key>& keys, const std::vector<vec4>& positions, const SubstepParams<float>& params) {
    return std::ranges::all_of(keys, [&](const Key& key) {
        if (key.ball_id >= positions.size()) {
            return key.ball_id == SENTINEL;
        }
        const uvec3 cell = cpu::cell_coordinates(params, vec3(positions[key.ball_id]));
        return key.cell_id == (cell.z * params.grid_cells.y + cell.y) * params.grid_cells.x + cell.x;
    });
}

std::uint32_t first_of(const Schedule& schedule, Stage stage) {
    const auto found = std::ranges::find(schedule.dispatches, stage, &Dispatch::stage);
    return static_cast<std::uint32_t>(found - schedule.dispatches.begin());
}

void take_grid(measure::BufferSample& sample, const SlotBytes& copies) {
    sample.keys = elements<Key>(copies[Slot::keys]);
    sample.cell_ranges = elements<CellRange>(copies[Slot::cell_ranges]);
    const bool filled = std::ranges::any_of(sample.keys, [](const Key& key) { return key.ball_id != SENTINEL; });
    if (!filled) {
        sample.keys.clear();
    }
    if (!filled || sample.cell_ranges.size() != sample.grid.cell_count()) {
        sample.cell_ranges.clear();
    }
}

void between_substeps(measure::BufferSample& sample, const SlotBytes& copies, const SubstepParams<double>& params) {
    const auto before = elements<vec4>(copies[Slot::next_positions]);
    if (before.empty() || same(before, sample.positions)) {
        return;
    }
    const auto narrow = narrowed<float>(params);
    const bool prepared = !sample.keys.empty() && !made_from(sample.keys, before, narrow) &&
                          made_from(sample.keys, sample.positions, narrow);
    if (!prepared) {
        sample.next_positions = std::exchange(sample.positions, before);
        sample.next_velocities = std::exchange(sample.velocities, elements<vec4>(copies[Slot::next_velocities]));
    }
}

}  // namespace

std::optional<measure::BufferSample> make_sample(const SlotBytes& copies, const Schedule& schedule,
                                                 const SubstepParams<double>& params, std::uint32_t dispatch) {
    if (copies[Slot::positions] == nullptr) {
        return std::nullopt;
    }
    measure::BufferSample sample;
    sample.grid = schedule.grid;
    sample.uses_grid = schedule.cell_count > 0;
    sample.positions = elements<vec4>(copies[Slot::positions]);
    sample.velocities = elements<vec4>(copies[Slot::velocities]);
    if (sample.uses_grid) {
        take_grid(sample, copies);
    }
    if (dispatch == 0) {
        between_substeps(sample, copies, params);
    } else if (dispatch < first_of(schedule, Stage::collide)) {
        sample.cell_ranges.clear();  // of the substep before, or half made
    }
    return sample;
}

}  // namespace ballpit::app
