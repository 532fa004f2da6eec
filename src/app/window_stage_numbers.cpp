#include "app/window_stage_numbers.h"

namespace ballpit::app {

namespace {

const Dispatch* ran_last(const ui::SteppingState& stepping) {
    const std::uint32_t ran = stepping.place.ran;
    return ran == 0 || ran > stepping.schedule->dispatches.size() ? nullptr : &stepping.schedule->dispatches[ran - 1];
}

template <class T>
std::vector<T> copy_of(const Inspector& inspector, Slot slot) {
    const Bytes* bytes = inspector.bytes(slot);
    return bytes == nullptr ? std::vector<T>() : typed<T>(*bytes);
}

measure::StageNumbers numbers_of(const Inspector& inspector, const ui::SteppingState& stepping, const Box& box) {
    const Dispatch* dispatch = ran_last(stepping);
    if (dispatch == nullptr) {
        return {};
    }
    const Schedule& schedule = *stepping.schedule;
    switch (dispatch->program.shader) {
        case Shader::assign_cells:
            return measure::assign_numbers(schedule, copy_of<Key>(inspector, Slot::keys),
                                           copy_of<vec4>(inspector, Slot::positions), box);
        case Shader::bitonic_sort:
        case Shader::bitonic_sort_fused:
        case Shader::bitonic_sort_strides:
            return measure::sort_numbers(schedule, *dispatch, typed<Key>(inspector.keys_before()));
        case Shader::clear_cells:
            return measure::ClearNumbers{schedule.cell_count};
        case Shader::count_cells:
        case Shader::count_tiles:
        case Shader::start_order:
        case Shader::put_back:
            return {};  // the table holds counts, no ranges yet; where somebody steps, no order is kept
        case Shader::build_grid:
        case Shader::scan_cells:
        case Shader::scatter_keys:
        case Shader::order_keys:
        case Shader::count_missed:
        case Shader::keep_places:
        case Shader::gather:
            return measure::build_numbers(copy_of<CellRange>(inspector, Slot::cell_ranges));
        case Shader::collide:
            if (schedule.in_place) {
                return measure::collide_numbers(copy_of<vec4>(inspector, Slot::positions),
                                                copy_of<vec4>(inspector, Slot::velocities));
            }
            // Its output has become the state, its input the other buffer.
            return measure::collide_numbers(copy_of<vec4>(inspector, Slot::next_positions),
                                            copy_of<vec4>(inspector, Slot::velocities));
    }
    return {};
}

}  // namespace

void StageNumbersReader::ask(Inspector& inspector, const ui::SteppingState& stepping) {
    const Dispatch* dispatch = ran_last(stepping);
    if (dispatch == nullptr) {
        return;
    }
    switch (dispatch->program.shader) {
        case Shader::assign_cells:
            inspector.want(Slot::keys);
            inspector.want(Slot::positions);
            break;
        case Shader::bitonic_sort:
        case Shader::bitonic_sort_fused:
        case Shader::bitonic_sort_strides:
            inspector.want(Slot::keys);  // the next pass then finds them as its keys before
            inspector.want_keys_before();
            break;
        case Shader::clear_cells:
        case Shader::count_cells:
        case Shader::count_tiles:
        case Shader::start_order:
        case Shader::put_back:
            break;
        case Shader::build_grid:
        case Shader::scan_cells:
        case Shader::scatter_keys:
        case Shader::order_keys:
        case Shader::gather:
        case Shader::count_missed:
        case Shader::keep_places:
            inspector.want(Slot::cell_ranges);
            break;
        case Shader::collide:
            inspector.want(stepping.schedule->in_place ? Slot::positions : Slot::next_positions);
            inspector.want(Slot::velocities);
            break;
    }
}

const measure::StageNumbers& StageNumbersReader::read(const Inspector& inspector, const ui::SteppingState& stepping,
                                                      const Box& box, std::uint64_t revision) {
    if (revision != revision_ || stepping.place != place_) {
        revision_ = revision;
        place_ = stepping.place;
        numbers_ = numbers_of(inspector, stepping, box);
    }
    return numbers_;
}

}  // namespace ballpit::app
