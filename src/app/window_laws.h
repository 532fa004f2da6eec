// The laws of the scene in the window: their costs, measured while the panel is open, and the programs that stand for
// them, built ahead or told of.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "app/law_meter.h"
#include "app/window_session.h"
#include "ui/laws.h"
#include "ui/state.h"

namespace ballpit::app {

class WindowLaws {
public:
    void measure_again() { measured_.reset(); }

    /// Once a frame. Measures while `open`, and again once scene, count or settings have been others for a moment;
    /// closed, nothing is kept and nothing runs. `now_s` of the window's clock; `frame_ms`: what a frame takes.
    void update(Session& session, bool open, double now_s, double frame_ms);

    /// Compiles a program of the shipped scenes that is not there yet.
    void build_ahead(Session& session);
    /// Whether there is something to do though nothing moves.
    bool working() const { return meter_.busy() || building_ || settling_; }

    /// Null while closed; valid until the next call.
    const ui::LawsState* describe(const Session& session, bool open);
    std::string take_message() { return std::exchange(message_, {}); }

private:
    // What costs depend on, beside the state itself.
    struct Measured {
        Settings settings;
        int scene_changes = 0;
        const Backend* backend = nullptr;
        friend bool operator==(const Measured&, const Measured&) = default;
    };

    static Measured to_measure(const Session& session);
    void measure(Session& session, double now_s);
    void tell_of_programs(const Session& session);

    LawMeter meter_;
    std::optional<Measured> measured_;
    std::optional<Measured> wanted_;
    double wanted_since_s_ = 0.0;
    bool settling_ = false;
    bool building_ = true;
    std::uint64_t layout_ = 0;  // of the session, as far as its programs were looked at
    std::set<Program> told_;
    ui::LawsState state_;
    std::string message_;
};

}  // namespace ballpit::app
