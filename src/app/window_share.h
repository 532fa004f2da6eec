// Sharing and keeping as the window's loop meets them: the panel, codes out and in, scene files, the hash in the
// corner.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "app/clock.h"
#include "app/share_code.h"
#include "app/shared_run.h"
#include "app/window_camera.h"
#include "app/window_session.h"
#include "app/window_views.h"
#include "ui/commands.h"
#include "ui/share.h"
#include "view/light.h"

namespace ballpit::app {

/// What of the window a code remembers and sets.
struct Seen {
    ui::ViewOptions& view;
    view::Light& light;
    WindowCamera& camera;
    Views& views;
    ui::Inspection& inspection;
};

/// The same, as plain values.
Shown shown_now(const Seen& seen);

class Sharing {
public:
    /// All of it must outlive this.
    Sharing(Session& session, Clock& clock, const Seen& seen) : session_(session), clock_(clock), seen_(seen) {}

    /// True where the action is one of these.
    bool act(ui::Action action);
    void act(const ui::CopyCode&);
    void act(const ui::NameFile& command) { state_.file = command.name; }

    /// Opens what a code shows: its scene at once, then the way to its moment, slice by slice in update(). A code that
    /// is refused leaves everything as it was.
    void open_code(const std::string& text);
    /// A scene file, dropped on the window.
    void open_file(const std::string& file);

    /// While it replays, nothing else may touch the run.
    bool replaying() const { return replay_.has_value(); }
    /// What lies on top closes: a replay stops where it is, the panel goes. False: there was neither.
    bool close();

    /// Once a frame, when camera and views have had their turn.
    void update();
    /// Whether the next frame will have news.
    bool working() const { return replaying() || look_wanted_; }

    const ui::ShareState& state() const { return state_; }
    std::string take_message() { return std::exchange(message_, {}); }

private:
    SharedCode code_of_now();
    void open_panel();
    void copy();
    void save();
    void paste();
    void show_as_sent();
    void compare();

    Session& session_;
    Clock& clock_;
    Seen seen_;
    ui::ShareState state_;
    std::optional<Replay> replay_;
    SharedCode sent_;                             // the code that was opened last
    bool look_wanted_ = false;                    // the replay has arrived: the view of the code comes next
    std::optional<std::uint64_t> compared_step_;  // at which the replay arrived
    int scene_changes_ = 0;                       // as the code's scene had it
    std::string named_;                           // the file name that was proposed
    std::string message_;
};

}  // namespace ballpit::app
