// The views that look inside a substep, as the window's loop meets them: keys and clicks in, wishes for copies, and one
// picture or two out.
#pragma once

#include <optional>
#include <string>

#include "app/window_extent.h"
#include "app/window_picture.h"
#include "app/window_probe.h"
#include "app/window_split.h"
#include "ui/commands.h"

namespace ballpit::app {

class Views {
public:
    /// True where the action is one of these views'.
    bool act(ui::Action action, ui::Inspection& inspection, const Session& session);
    void act(const ui::ChangeProbe& command) { probe_.choose(command.options); }
    void act(const ui::ShowElement& command) { probe_.show_element(command.slot, command.element); }
    void select_cell_of_ball(std::uint32_t ball, ui::Inspection& inspection);
    void select_cell(std::optional<std::uint32_t> cell, ui::Inspection& inspection);
    void export_slot(Slot slot, const Inspector& inspector, const Session& session) {
        probe_.start_export(slot, inspector, session);
    }
    /// What lies under a click becomes what is looked at. Reads positions or cells once, and may wait for that.
    void pick(const view::vec2& click, bool control, const WindowExtent& extent, const view::Camera& camera,
              Session& session, ui::Inspection& inspection);

    const ui::ProbeOptions& probe_options() const { return probe_.options(); }
    bool shows_slice() const { return probe_.options().slice; }
    bool needs_cells(const ui::ViewOptions& view, const ui::Inspection& inspection) const {
        return probe_.needs_cells(view.colour, inspection.ball.has_value());
    }
    void want(Inspector& inspector, const ui::ViewOptions& view, const ui::Inspection& inspection) const;
    /// After Inspector::update(); `now_s` of the window's clock.
    void update(Session& session, const Inspector& inspector, const ui::Inspection& inspection,
                const ui::ViewOptions& view, const ui::LiveCheckState& check, bool running, double now_s);
    bool working() const { return probe_.working(); }
    std::string take_message();

    bool split() const { return split_.open(); }
    void add_grid_times(std::span<const StageTimes> times);

    void add_to(view::Overlay& overlay, const ui::Inspection& inspection, const Session& session) const {
        probe_.add_to(overlay, inspection, session.simulation().schedule().grid);
    }
    void describe(ui::ProbeState& state, const Session& session, const ui::Inspection& inspection,
                  const ui::ViewOptions& view, std::uint32_t top_count);
    /// `width` and `height` of the framebuffer, pixels.
    void draw(WindowPicture& picture, Session& session, PictureOptions options, const WindowExtent& extent, int width,
              int height);

private:
    void follow_split(Session& session, bool running, double now_s);
    void step_ball(int offset, ui::Inspection& inspection, const Session& session);
    void step_layer(int offset, const Session& session);

    Probe probe_;
    Split split_;
    std::string message_;
};

}  // namespace ballpit::app
