// Readings of the meters, made on the GPU and read late: two dispatches a reading, a ring of results, one small copy a
// frame. Nothing is compiled or allocated before the first one is asked for.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <vector>

#include "core/meter.h"
#include "core/schedule.h"
#include "core/substep_params.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/readback.h"
#include "gl/timer.h"
#include "gpu/params_block.h"

namespace ballpit::gpu {

class Meter {
public:
    explicit Meter(std::filesystem::path shader_folder) : folder_(std::move(shader_folder)) {}

    /// The slots that the meter of these features reads.
    static std::vector<Slot> slots(Features features);

    /// Those slots must be bound, and visible to shaders. `slices`: what it is cut into where balls look at others.
    void request(std::uint64_t tag, Features features, const ShaderParams& params,
                 const Synchronisation& synchronisation, std::uint32_t slices);

    /// The readings that have arrived, in the order of asking; never waits.
    std::vector<TaggedReading> take();
    /// ms that they took, as far as it is known.
    std::vector<double> take_times();

private:
    struct Compiled {
        gl::Program program;
        ParamsBlock params;
        GLint synchronisation = -1;  // uniform locations
        GLint constants = -1;
    };
    struct Pending {
        std::uint64_t tag;
        std::uint32_t entry;
    };

    void prepare(std::uint32_t parts);
    Compiled& program_of(Features features);
    static void dispatch_slices(const Compiled& compiled, std::uint32_t balls, std::uint32_t count);
    void start_copy();
    void deliver(const std::vector<std::byte>& ring);

    std::filesystem::path folder_;
    std::map<Features, Compiled> programs_;
    gl::Program sum_;
    GLint sum_constants_ = -1;
    gl::Buffer parts_;
    gl::Buffer ring_;
    gl::Readback readback_;
    std::uint32_t next_entry_ = 0;
    std::deque<Pending> waiting_;  // asked for, oldest first
    std::size_t copied_ = 0;       // of those, how many the copy under way holds
    std::vector<TaggedReading> arrived_;
    gl::SpanTimer timer_;
};

}  // namespace ballpit::gpu
