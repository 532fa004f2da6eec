#include "gpu/gpu_backend.h"

#include <algorithm>
#include <utility>

#include "core/contact.h"
#include "core/error.h"
#include "core/ledger.h"
#include "gl/debug.h"
#include "gl/error.h"
#include "gl/memory.h"
#include "gl/reset.h"
#include "gpu/barriers.h"

namespace ballpit::gpu {

namespace {

constexpr std::array grid_slots = {
    Slot::keys,           Slot::cell_ranges, Slot::built_positions, Slot::used_tiles,       Slot::tickets,
    Slot::scattered_keys, Slot::tile_counts, Slot::origins,         Slot::sorted_positions, Slot::sorted_velocities};

std::string gl_text(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text == nullptr ? "" : text;
}

}  // namespace

GpuBackend::GpuBackend(std::filesystem::path shader_folder)
    : GpuBackend(std::make_shared<Programs>(std::move(shader_folder))) {}

GpuBackend::GpuBackend(std::shared_ptr<Programs> programs)
    : programs_(std::move(programs)), hasher_(programs_->folder()), meter_(programs_->folder()) {
    if (GLAD_GL_VERSION_4_3 == 0) {
        throw gl::Error("the GPU backend needs OpenGL 4.3, this context has " + gl_text(GL_VERSION));
    }
}

std::string GpuBackend::device() const { return gl_text(GL_RENDERER); }

std::string GpuBackend::driver() const { return gl_text(GL_VERSION); }

void GpuBackend::make_room(std::span<const SlotRoom> rooms) {
    std::vector<gl::Buffer> grown(rooms.size());
    for (std::size_t i = 0; i < rooms.size(); ++i) {
        if (buffer(rooms[i].slot).size() < rooms[i].bytes) {
            try {
                grown[i] = gl::Buffer(slot_name(rooms[i].slot), rooms[i].bytes);
            } catch (const gl::Error& error) {
                throw NoRoom(error.what());
            }
        }
    }
    for (std::size_t i = 0; i < rooms.size(); ++i) {
        const auto [slot, bytes] = rooms[i];
        if (bytes == 0 || grown[i].size() != 0) {
            buffer(slot) = std::move(grown[i]);  // what a scene does not need is not kept
        }
        used_bytes_[physical(slot)] = bytes;
    }
}

StorageLimits GpuBackend::storage_limits() const {
    StorageLimits limits;
    GLint value = 0;
    glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &value);
    limits.blocks = static_cast<std::uint32_t>(value);
    glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &value);
    limits.bindings = static_cast<std::uint32_t>(value);
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    limits.block_bytes = static_cast<std::size_t>(bytes);
    limits.free_bytes = gl::free_memory();
    if (limits.free_bytes) {
        *limits.free_bytes += allocated_bytes();  // they are given back
    }
    return limits;
}

std::vector<GpuBackend::SlotRoom> GpuBackend::rooms_of(const Schedule& schedule) {
    const auto bytes = bytes_of(schedule);
    std::vector<SlotRoom> rooms;
    for (std::size_t i = 0; i < slot_count; ++i) {
        rooms.push_back({static_cast<Slot>(i), bytes[i]});
    }
    return rooms;
}

// Now, so that no substep waits for it.
void GpuBackend::compile(const Schedule& schedule) {
    const Schedule whole = can_keep_order(schedule) ? there_and_back(schedule) : schedule;
    for (const Schedule* each : {&schedule, &whole}) {
        for (const Dispatch& dispatch : each->dispatches) {
            programs_->get(dispatch.program);
        }
    }
}

void GpuBackend::load(const BallState& state, const Schedule& schedule, bool limit_force) {
    expect_storage(schedule, storage_limits());
    compile(schedule);
    const std::vector<float> ratios = damping_ratios_of(state.restitutions, limit_force);
    std::vector<SlotRoom> rooms = rooms_of(schedule);
    rooms[static_cast<std::size_t>(Slot::damping_ratios)].bytes = ratios.size() * sizeof(float);
    make_room(rooms);
    in_order_ = false;
    in_place_of_ids_ = true;
    const Status clean{};
    write(Slot::positions, std::as_bytes(std::span(state.positions)));
    write(Slot::velocities, std::as_bytes(std::span(state.velocities)));
    if (!schedule.in_place) {
        write(Slot::next_positions, std::as_bytes(std::span(state.positions)));
        write(Slot::next_velocities, std::as_bytes(std::span(state.velocities)));
    }
    write(Slot::damping_ratios, std::as_bytes(std::span(ratios)));
    // Nothing has been left out so far where the state does not say.
    std::vector<Compensation> compensations = state.compensations;
    compensations.resize(used_bytes_[physical(Slot::compensations)] / sizeof(Compensation));
    write(Slot::compensations, std::as_bytes(std::span(compensations)));
    write(Slot::status, std::as_bytes(std::span(&clean, 1)));
    forget_grid(schedule);
    slicer_.load(state, schedule);
}

void GpuBackend::reschedule(const Schedule& schedule) {
    expect_storage(schedule, storage_limits());
    compile(schedule);
    leave_order();
    std::vector<SlotRoom> rooms;
    for (const SlotRoom& room : rooms_of(schedule)) {
        if (std::ranges::find(grid_slots, room.slot) != grid_slots.end()) {
            rooms.push_back(room);
        }
    }
    make_room(rooms);
    forget_grid(schedule);
}

// Whoever looks before the first substep sees no keys and empty cells, not what memory held.
void GpuBackend::forget_grid(const Schedule& schedule) {
    readbacks_ = {};  // a copy under way is of buffers that no longer hold
    for (const Slot slot : grid_slots) {
        use(slot, Use::copy);
        gl::fill(buffer(slot), used_bytes_[physical(slot)], slot == Slot::keys ? SENTINEL : 0);
    }
    if (schedule.keeps_places) {  // nothing has moved since a grid that was never built
        use(Slot::positions, Use::copy);
        use(Slot::built_positions, Use::copy);
        gl::copy(buffer(Slot::positions), buffer(Slot::built_positions), used_bytes_[physical(Slot::positions)]);
    }
}

void GpuBackend::barrier(Uses uses) {
    if (uses != 0) {
        glMemoryBarrier(barrier_bits(uses));
        hazards_.issued(uses);
        ++barriers_issued_;
    }
}

void GpuBackend::use(Slot slot, Use use) {
    look_at(slot);
    barrier(hazards_.before_use(slot, use));
}

void GpuBackend::run_slices(const Dispatch& dispatch, const Schedule& schedule, Programs::Compiled& compiled) {
    const std::uint32_t count = slicer_.slices(schedule, cells_looked_at(dispatch.program));
    const bool longest = dispatch.program.shader == Shader::collide;
    if (longest) {
        slicer_.begin(schedule);
    }
    if (count == 1) {
        compiled.set(dispatch.constants);
        glDispatchCompute(dispatch.groups.x, dispatch.groups.y, 1);
        ++dispatches_issued_;
    } else {
        for (const Slice& slice : slices_of(schedule.ball_count, count)) {
            auto constants = dispatch.constants;
            constants[3] = slice.first;
            compiled.set(constants);
            glDispatchCompute(slice.groups.x, slice.groups.y, 1);
            glFlush();  // else a driver may send all of them as one piece of work
            ++dispatches_issued_;
        }
    }
    if (longest) {
        slicer_.end(count);
    }
}

void GpuBackend::run_dispatch(const Dispatch& dispatch, const Schedule& schedule, const ShaderParams& params) {
    const gl::DebugGroup group(dispatch.name);
    Programs::Compiled& compiled = programs_->get(dispatch.program);
    compiled.program.use();
    compiled.params.bind(params);
    for (const std::vector<Slot>* slots : {&dispatch.reads, &dispatch.writes}) {
        for (const Slot slot : *slots) {
            buffer(slot).bind_base(GL_SHADER_STORAGE_BUFFER, binding_of(dispatch.program.shader, slot));
        }
    }
    barrier(hazards_.before(dispatch));
    if (looks_at_pairs(dispatch.program)) {
        run_slices(dispatch, schedule, compiled);
    } else {
        compiled.set(dispatch.constants);
        glDispatchCompute(dispatch.groups.x, dispatch.groups.y, 1);
        ++dispatches_issued_;
    }
    hazards_.ran(dispatch);
}

void GpuBackend::run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first,
                     std::size_t last) {
    if (first == last) {
        return;
    }
    if (!schedule.keeps_order) {
        leave_order();
    } else if (first == 0) {
        begin_order(schedule);
    }
    const auto shader_params = narrowed<float>(params);
    const bool timed = timing_ && first == 0 && last == schedule.dispatches.size();
    if (timed) {
        timer_.begin();
    }
    for (std::size_t i = first; i < last; ++i) {
        run_dispatch(schedule.dispatches[i], schedule, shader_params);
        const Stage stage = schedule.dispatches[i].stage;
        if (timed && (i + 1 == last || schedule.dispatches[i + 1].stage != stage)) {
            timer_.mark(static_cast<int>(stage));
            // llvmpipe looks at its clock at the next barrier, which the next dispatch need not ask for.
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        }
    }
    if (timed) {
        timer_.end();
    }
}

void GpuBackend::swap_states() { hazards_.swap_states(); }

void GpuBackend::request_hash(std::uint64_t tag) {
    use(Slot::positions, Use::storage);
    use(Slot::velocities, Use::storage);
    hasher_.request(tag, buffer(Slot::positions), buffer(Slot::velocities),
                    static_cast<std::uint32_t>(used_bytes_[physical(Slot::positions)] / sizeof(vec4)));
    hazards_.shader_reads(Slot::positions);
    hazards_.shader_reads(Slot::velocities);
}

void GpuBackend::request_reading(std::uint64_t tag, const Schedule& schedule, const SubstepParams<double>& params,
                                 const Synchronisation& synchronisation) {
    const std::vector<Slot> slots = Meter::slots(schedule.features);
    for (const Slot slot : slots) {
        use(slot, Use::storage);
        buffer(slot).bind_base(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(slot));
    }
    meter_.request(tag, schedule.features, narrowed<float>(params), synchronisation,
                   schedule.features.has(Feature::contact) ? slicer_.slices(schedule) : 1);
    for (const Slot slot : slots) {
        hazards_.shader_reads(slot);
    }
}

std::vector<StageTimes> GpuBackend::take_times() {
    std::vector<StageTimes> all;
    for (const gl::SpanTimer::Span& span : timer_.take()) {
        StageTimes times{};
        for (const gl::SpanTimer::Part& part : span) {
            times[static_cast<std::size_t>(part.tag)] += part.ms;
        }
        all.push_back(times);
    }
    return all;
}

void GpuBackend::finish() {
    glFinish();
    gl::expect_context();
}

const gl::Buffer& GpuBackend::buffer_for_drawing(Slot slot) {
    look_at(slot);
    barrier(hazards_.before_use(slot, Use::vertex) | hazards_.before_use(slot, Use::texture) |
            hazards_.before_use(slot, Use::storage));
    hazards_.shader_reads(slot);
    return buffer(slot);
}

std::size_t GpuBackend::allocated_bytes() const {
    std::size_t bytes = 0;
    for (const gl::Buffer& each : buffers_) {
        bytes += each.size();
    }
    return bytes;
}

}  // namespace ballpit::gpu
