// The numbers of the sentence under the strip: which slots they need, and what they are.
#pragma once

#include <cstdint>

#include "app/window_inspector.h"
#include "measure/stage_numbers.h"
#include "ui/stepping.h"

namespace ballpit::app {

class StageNumbersReader {
public:
    /// While paused, with the strip open: before the inspector's update().
    static void ask(Inspector& inspector, const ui::SteppingState& stepping);
    /// After it; worked out anew only when the revision is another.
    const measure::StageNumbers& read(const Inspector& inspector, const ui::SteppingState& stepping, const Box& box,
                                      std::uint64_t revision);

private:
    measure::StageNumbers numbers_;
    ui::Place place_;
    std::uint64_t revision_ = ~std::uint64_t{0};
};

}  // namespace ballpit::app
