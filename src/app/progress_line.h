// How far long work has come: one line on the terminal that is written over. Where standard error is no terminal there
// is none.
#pragma once

#include <optional>

namespace ballpit::app {

class ProgressLine {
public:
    ProgressLine();

    /// `share`: of the work, from 0 to 1. `seconds_left`: where it is known.
    void show(double share, std::optional<double> seconds_left) const;
    /// Makes room for other lines.
    void clear() const;

private:
    bool shown_;
};

}  // namespace ballpit::app
