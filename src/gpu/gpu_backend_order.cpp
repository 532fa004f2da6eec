// How GpuBackend hides that balls stay in the order of their cells between two substeps (schedule.h).
#include <cassert>

#include "gpu/gpu_backend.h"

namespace ballpit::gpu {

// Before a substep that keeps the order.
void GpuBackend::begin_order(const Schedule& schedule) {
    if (!in_order_) {
        assert(!schedule.swaps_copies);
        run_dispatch(start_order(schedule.ball_count), schedule, ShaderParams{});
        balls_in_order_ = schedule.ball_count;
    }
    if (schedule.swaps_copies) {
        hazards_.swap_copies();
    }
    in_order_ = true;
    in_place_of_ids_ = false;
}

// Before somebody looks at positions or velocities. The order stays, and the next substep may keep it.
void GpuBackend::bring_back() {
    if (!in_place_of_ids_) {
        in_place_of_ids_ = true;
        run_dispatch(put_back(balls_in_order_), Schedule{}, ShaderParams{});
    }
}

void GpuBackend::look_at(Slot slot) {
    if (slot == Slot::positions || slot == Slot::velocities) {
        bring_back();
    }
}

// Before somebody changes what the order consists of.
void GpuBackend::leave_order() {
    bring_back();
    in_order_ = false;
}

}  // namespace ballpit::gpu
