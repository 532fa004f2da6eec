#include "gpu/meter.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "core/backend.h"
#include "core/dispatch_slices.h"
#include "gl/debug.h"
#include "gpu/programs.h"

namespace ballpit::gpu {

namespace {

// Without what meter.comp does not look at, which must not split its permutations.
Features relevant(Features features) {
    for (const Feature feature :
         {Feature::drag, Feature::velocity_verlet, Feature::forward_euler, Feature::historical, Feature::diagnostics,
          Feature::compensated, Feature::sorted_copies, Feature::kept_order}) {
        features.bits &= ~static_cast<std::uint32_t>(feature);
    }
    return features;
}

}  // namespace

std::vector<Slot> Meter::slots(Features features) {
    std::vector<Slot> slots{Slot::positions, Slot::velocities};
    if (features.has(Feature::contact)) {
        slots.push_back(Slot::next_velocities);
        if (!features.has(Feature::brute_force)) {
            slots.insert(slots.end(), {Slot::keys, Slot::cell_ranges});
        }
    }
    if (features.has(Feature::ball_restitution)) {
        slots.push_back(Slot::damping_ratios);
    }
    return slots;
}

void Meter::prepare(std::uint32_t parts) {
    if (ring_.size() == 0) {
        const std::array stages = {gl::ShaderStage{GL_COMPUTE_SHADER, gl::load_shader(folder_, "meter_sum.comp")}};
        sum_ = gl::Program(stages);
        sum_constants_ = sum_.uniform("dispatch_constants");
        ring_ = gl::Buffer("meter ring", std::size_t{METER_RING_SIZE} * METER_VALUES * sizeof(float));
    }
    const std::size_t bytes = std::max<std::size_t>(parts, 1) * METER_VALUES * sizeof(float);
    if (parts_.size() < bytes) {
        parts_ = gl::Buffer("meter parts", bytes);
    }
}

Meter::Compiled& Meter::program_of(Features features) {
    const auto found = programs_.find(relevant(features));
    if (found != programs_.end()) {
        return found->second;
    }
    const std::vector<std::string_view> defines = defines_of(relevant(features));
    const std::array stages = {gl::ShaderStage{GL_COMPUTE_SHADER, gl::load_shader(folder_, "meter.comp", defines)}};
    Compiled compiled;
    compiled.program = gl::Program(stages);
    compiled.params = ParamsBlock(compiled.program);
    compiled.synchronisation = compiled.program.uniform("synchronisation");
    compiled.constants = compiled.program.uniform("dispatch_constants");
    return programs_.emplace(relevant(features), std::move(compiled)).first->second;
}

void Meter::dispatch_slices(const Compiled& compiled, std::uint32_t balls, std::uint32_t count) {
    if (count == 1) {
        const Groups groups = groups_for(balls, GROUP_SIZE);
        glUniform4ui(compiled.constants, 0, 0, 0, 0);
        glDispatchCompute(groups.x, groups.y, 1);
        return;
    }
    for (const Slice& slice : slices_of(balls, count)) {
        glUniform4ui(compiled.constants, 0, 0, 0, slice.first);
        glDispatchCompute(slice.groups.x, slice.groups.y, 1);
        glFlush();
    }
}

void Meter::request(std::uint64_t tag, Features features, const ShaderParams& params,
                    const Synchronisation& synchronisation, std::uint32_t slices) {
    const std::uint32_t parts = (params.ball_count + GROUP_SIZE - 1) / GROUP_SIZE;
    prepare(parts);
    if (waiting_.size() == METER_RING_SIZE) {  // nobody took any: the oldest entry would be overwritten unread
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        copied_ = waiting_.size();
        deliver(ring_.read());
        readback_ = {};
    }
    const gl::DebugGroup group("meter");
    timer_.begin();
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the reading before has read its parts
    parts_.bind_base(GL_SHADER_STORAGE_BUFFER, BINDING_METER_PARTS);
    ring_.bind_base(GL_SHADER_STORAGE_BUFFER, BINDING_METER_RING);
    if (parts > 0) {
        Compiled& compiled = program_of(features);
        compiled.program.use();
        compiled.params.bind(params);
        const std::array factors = {static_cast<GLfloat>(synchronisation.old_velocity),
                                    static_cast<GLfloat>(synchronisation.new_velocity),
                                    static_cast<GLfloat>(synchronisation.acceleration), 0.0f};
        glUniform4fv(compiled.synchronisation, 1, factors.data());
        dispatch_slices(compiled, params.ball_count, slices);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    sum_.use();
    const std::array<GLuint, 4> constants = {next_entry_, parts, 0, 0};
    glUniform4uiv(sum_constants_, 1, constants.data());
    glDispatchCompute(1, 1, 1);
    timer_.mark(0);
    timer_.end();
    waiting_.push_back({tag, next_entry_});
    next_entry_ = (next_entry_ + 1) % METER_RING_SIZE;
}

void Meter::start_copy() {
    if (!readback_.under_way() && !waiting_.empty()) {
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        readback_.request(ring_, ring_.size());
        copied_ = waiting_.size();
    }
}

void Meter::deliver(const std::vector<std::byte>& ring) {
    const auto values = typed<float>(ring);
    for (; copied_ > 0; --copied_) {
        const Pending& pending = waiting_.front();
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(pending.entry * std::size_t{METER_VALUES});
        const std::vector<double> entry(first, first + METER_VALUES);
        arrived_.push_back({pending.tag, reading_of(entry)});
        waiting_.pop_front();
    }
}

std::vector<TaggedReading> Meter::take() {
    if (const auto ring = readback_.poll()) {
        deliver(*ring);
    }
    start_copy();
    return std::exchange(arrived_, {});
}

std::vector<double> Meter::take_times() {
    std::vector<double> times;
    for (const gl::SpanTimer::Span& span : timer_.take()) {
        for (const gl::SpanTimer::Part& part : span) {
            times.push_back(part.ms);
        }
    }
    return times;
}

}  // namespace ballpit::gpu
