#include "app/window_views.h"

#include <algorithm>
#include <cmath>

#include "app/room.h"
#include "core/error.h"
#include "gl/error.h"
#include "view/picking.h"

namespace ballpit::app {

bool Views::act(ui::Action action, ui::Inspection& inspection, const Session& session) {
    ui::ProbeOptions options = probe_.options();
    switch (action) {
        case ui::Action::toggle_follow:
            options.follow = !options.follow;
            break;
        case ui::Action::toggle_cells:
            options.cells = !options.cells;
            break;
        case ui::Action::toggle_buffers:
            options.buffers = !options.buffers;
            break;
        case ui::Action::toggle_split:
            options.split = !options.split;
            break;
        case ui::Action::toggle_contacts:
            options.contacts = !options.contacts;
            break;
        case ui::Action::toggle_arrows:
            options.arrows = !options.arrows;
            break;
        case ui::Action::toggle_slice:
            options.slice = !options.slice;
            break;
        case ui::Action::slice_axis:
            options.slice_axis = (options.slice_axis + 1) % 3;
            break;
        case ui::Action::next_slot:
            options.slot = static_cast<Slot>((static_cast<std::size_t>(options.slot) + 1) % slot_count);
            break;
        case ui::Action::layer_up:
            step_layer(1, session);
            return true;
        case ui::Action::layer_down:
            step_layer(-1, session);
            return true;
        case ui::Action::next_ball:
            step_ball(1, inspection, session);
            return true;
        case ui::Action::previous_ball:
            step_ball(-1, inspection, session);
            return true;
        case ui::Action::clear_selection:
            inspection.ball.reset();
            inspection.cell.reset();
            return true;
        default:
            return false;
    }
    probe_.choose(options);
    return true;
}

// Around the ends; the first press takes ball 0.
void Views::step_ball(int offset, ui::Inspection& inspection, const Session& session) {
    const auto count = std::int64_t{session.simulation().schedule().ball_count};
    if (count == 0) {
        return;
    }
    const std::int64_t now = inspection.ball ? std::int64_t{*inspection.ball} : offset > 0 ? -1 : count;
    inspection.ball = static_cast<std::uint32_t>((now + offset + count) % count);
    ui::ProbeOptions options = probe_.options();
    options.follow = true;
    probe_.choose(options);
}

void Views::step_layer(int offset, const Session& session) {
    ui::ProbeOptions options = probe_.options();
    const std::int64_t most = std::int64_t{session.simulation().schedule().grid.cells[options.slice_axis]} - 1;
    const std::int64_t now = std::min(std::int64_t{options.slice_layer}, most);
    options.slice_layer = static_cast<std::uint32_t>(std::clamp<std::int64_t>(now + offset, 0, most));
    probe_.choose(options);
}

void Views::select_cell(std::optional<std::uint32_t> cell, ui::Inspection& inspection) {
    inspection.cell = cell;
    if (cell) {
        probe_.show_cell(*cell);
    }
}

void Views::select_cell_of_ball(std::uint32_t ball, ui::Inspection& inspection) {
    if (const auto cell = probe_.cell_of_ball(ball)) {
        select_cell(cell, inspection);
    } else {
        message_ = "There is no ball " + std::to_string(ball) + " in a cell now.";
    }
}

void Views::pick(const view::vec2& click, bool control, const WindowExtent& extent, const view::Camera& camera,
                 Session& session, ui::Inspection& inspection) {
    float left = 0.0f;
    float width = extent.width;
    Simulation* simulation = &session.simulation();
    if (split_.open()) {
        width = 0.5f * extent.free_width;
        const bool right_side = click.x >= width;
        left = right_side ? width : 0.0f;
        simulation = right_side ? &split_.simulation() : simulation;
    }
    if (click.x - left >= width) {
        return;
    }
    const view::vec2 point((click.x - left) / width, click.y / extent.height);
    const float aspect = width / extent.height;
    const ui::ProbeOptions& options = probe_.options();
    const Grid& grid = simulation->schedule().grid;
    const bool cells = options.click_picks_cell != control && simulation->schedule().cell_count > 0;
    const view::GridSlice slice{options.slice_axis, options.slice_layer, options.slice_cut};
    Backend& backend = simulation->backend();
    if (cells && options.slice) {
        select_cell(view::pick_cell(camera, aspect, point, grid, slice), inspection);
    } else if (cells) {
        const auto ranges = read_slot<CellRange>(backend, Slot::cell_ranges);
        select_cell(view::pick_cell(camera, aspect, point, grid, ranges), inspection);
    } else {
        const auto positions = read_slot<vec4>(backend, Slot::positions);
        const vec3 half_extent = room_half_extent(*simulation);
        inspection.ball = options.slice ? view::pick_ball(camera, half_extent, aspect, point, positions, grid, slice)
                                        : view::pick_ball(camera, half_extent, aspect, point, positions);
        if (inspection.ball) {
            probe_.open_follow();
        }
    }
}

void Views::want(Inspector& inspector, const ui::ViewOptions& view, const ui::Inspection& inspection) const {
    probe_.want(inspector, view.colour, inspection.ball.has_value());
}

void Views::update(Session& session, const Inspector& inspector, const ui::Inspection& inspection,
                   const ui::ViewOptions& view, const ui::LiveCheckState& check, bool running, double now_s) {
    probe_.update(session, inspector, inspection, view.colour, running);
    if (view.colour == ui::BallColour::difference) {
        probe_.take_differences(check, session.simulation().schedule().ball_count, session.revision());
    }
    follow_split(session, running, now_s);
}

// What keeps the second side from running closes it, and is told; the first side goes on.
void Views::follow_split(Session& session, bool running, double now_s) {
    if (!probe_.options().split) {
        if (split_.open()) {
            split_.stop();
        }
        return;
    }
    const auto close = [this](const std::string& why) {
        message_ = why;
        split_.stop();
        probe_.close_split();
    };
    try {
        if (const auto refusal = split_.follow(session)) {
            return close(*refusal);
        }
    } catch (const InputError& error) {
        return close(error.what());
    } catch (const DeviceError& error) {
        return close(error.what());
    } catch (const gl::Error& error) {
        return close(error.what());
    }
    split_.look(probe_.sample(), running, now_s, probe_.options().copies_a_second);
}

void Views::add_grid_times(std::span<const StageTimes> times) {
    if (split_.open()) {
        split_.add_grid_times(times);
    }
}

std::string Views::take_message() { return message_.empty() ? probe_.take_message() : std::exchange(message_, {}); }

void Views::describe(ui::ProbeState& state, const Session& session, const ui::Inspection& inspection,
                     const ui::ViewOptions& view, std::uint32_t top_count) {
    probe_.describe(state, session, inspection, {view.colour, view.occupancy, top_count, PictureOptions{}.top_speed});
    if (split_.open()) {
        split_.describe(state, session, probe_.pairs());
    }
}

void Views::draw(WindowPicture& picture, Session& session, PictureOptions options, const WindowExtent& extent,
                 int width, int height) {
    const ui::BallColour colour = options.view.colour;
    options.values = probe_.values(colour);
    options.value_low = probe_.value_low();
    options.value_high = probe_.value_high();
    if (!split_.open()) {
        picture.draw(session.simulation(), 0, options, {0, 0, width, height});
        return;
    }
    const float pixels_a_point = static_cast<float>(width) / std::max(extent.width, 1.0f);
    const int half = std::max(1, static_cast<int>(std::lround(0.5f * extent.free_width * pixels_a_point)));
    picture.draw(session.simulation(), 0, options, {0, 0, half, height});
    const view::Overlay& left = *options.overlay;
    view::Overlay right;  // cells and their slice are the grid's
    right.highlights = left.highlights;
    right.fade_others = left.fade_others;
    right.arrow_seconds = left.arrow_seconds;
    if (probe_.options().contacts) {
        split_.add_to(right, probe_.top_overlap());
    }
    options.overlay = &right;
    options.values = nullptr;
    options.view.occupancy = false;
    picture.draw(split_.simulation(), 1, options, {half, 0, half, height});
    if (width > 2 * half) {
        picture.draw_background({2 * half, 0, width - 2 * half, height});
    }
}

}  // namespace ballpit::app
