#include "app/bench_run.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <span>

#include "app/bench_timer.h"
#include "app/home_picture.h"
#include "core/ledger.h"
#include "core/stopwatch.h"
#include "measure/statistics.h"

namespace ballpit::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t fewest_steps = 2;
constexpr double shortest_warm_up_s = 0.1;

void begin_again(Simulation& simulation, const Checkpoint& start, const Settings& settings) {
    simulation.restore(start);
    simulation.change(settings);
    simulation.backend().finish();
}

// Compiles, wakes clocks, fills caches; gives the number of steps, up to the plan's, that fit into a quarter of the
// limit: it is one of several runs.
std::uint64_t warm_up(Simulation& simulation, const BenchPlan& plan) {
    const auto start = Clock::now();
    std::uint64_t steps = 0;
    double seconds = 0.0;
    while (steps == 0 || seconds < std::min(shortest_warm_up_s, plan.limit_s / 4.0) ||
           (steps < plan.steps && seconds < plan.limit_s / 4.0)) {
        simulation.step();
        simulation.backend().finish();
        ++steps;
        seconds = 1e-3 * milliseconds_since(start);
    }
    return std::min(plan.steps, std::max(steps, fewest_steps));
}

std::uint32_t missed_so_far(Simulation& simulation) {
    return read_slot<Status>(simulation.backend(), Slot::status).front().missed;
}

void time_substeps(Simulation& simulation, std::uint64_t steps, BenchRow& row) {
    BenchTimer timer(simulation.backend());
    const auto start = Clock::now();
    for (std::uint64_t i = 0; i < steps; ++i) {
        timer.begin();
        simulation.step();
        timer.mark();
        timer.end();
    }
    simulation.backend().finish();
    row.wall_ms = milliseconds_since(start) / static_cast<double>(steps * row.substeps);
    row.substep_ms = single_parts(timer.take());
    row.lost_times += steps - row.substep_ms.size();
    for (double& ms : row.substep_ms) {
        ms /= row.substeps;
    }
}

// The mean of these substeps.
void add_stages(BenchRow& row, std::span<const StageTimes> substeps) {
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        double ms = 0.0;
        for (const StageTimes& times : substeps) {
            ms += times[stage] / static_cast<double>(substeps.size());
        }
        row.stage_ms[stage].push_back(ms);
    }
}

void time_stages(Simulation& simulation, std::uint64_t steps, BenchRow& row) {
    Backend& backend = simulation.backend();
    backend.set_timing(true);
    const auto start = Clock::now();
    for (std::uint64_t i = 0; i < steps; ++i) {
        simulation.step();
    }
    backend.finish();
    const double wall_ms = milliseconds_since(start);
    backend.set_timing(false);
    const std::vector<StageTimes> times = backend.take_times();
    const std::size_t together = row.grid_reuse > 1 ? row.substeps : 1;
    row.stages_wall_ms = wall_ms / static_cast<double>(together);
    const std::size_t expected = simulation.schedule().dispatches.empty() ? 0 : steps * row.substeps;
    row.lost_times += expected - times.size();
    if (together > 1 && times.size() != expected) {
        return;  // nobody knows which of them belong together
    }
    for (std::size_t first = 0; first + together <= times.size(); first += together) {
        add_stages(row, std::span(times).subspan(first, together));
    }
}

// Each step's first substep, because a later one may have another list.
void time_dispatches(Simulation& simulation, std::uint64_t steps, BenchRow& row) {
    BenchTimer timer(simulation.backend());
    const auto start = Clock::now();
    for (std::uint64_t i = 0; i < steps; ++i) {
        const Schedule& schedule = simulation.whole_schedule();
        timer.begin();
        simulation.begin_substep();
        for (std::size_t d = 0; d < schedule.dispatches.size(); ++d) {
            simulation.backend().run(schedule, simulation.params(), d, d + 1);
            timer.mark();
        }
        timer.end();
        simulation.end_substep(schedule);
        simulation.step();  // the rest of it, or, where there is none, another one
    }
    simulation.backend().finish();
    row.dispatches_wall_ms = milliseconds_since(start);
    const auto spans = timer.take();
    row.lost_times += steps - spans.size();
    for (const auto& span : spans) {
        for (std::size_t d = 0; d < span.size(); ++d) {
            row.dispatches[d].ms.push_back(span[d]);
        }
    }
}

void time_frames(Simulation& simulation, std::uint64_t steps, BenchPicture& picture, BenchRow& row) {
    picture.draw(simulation);
    glFinish();
    BenchTimer timer(simulation.backend());
    const bool by_the_wall = simulation.backend().name() != "gpu";
    DrawnFrames frames;
    const auto start = Clock::now();
    for (std::uint64_t i = 0; i < steps; ++i) {
        timer.begin();
        simulation.step();
        timer.mark();
        picture.draw(simulation);
        if (by_the_wall) {
            glFinish();
        }
        timer.mark();
        timer.end();
    }
    glFinish();
    frames.wall_ms = milliseconds_since(start) / static_cast<double>(steps);
    for (const auto& span : timer.take()) {
        frames.frame_ms.push_back(span.at(0) + span.at(1));
        frames.picture_ms.push_back(span.at(1));
    }
    row.lost_times += steps - frames.frame_ms.size();
    row.frames = frames;
}

// Of the same frames again, the passes of each picture.
void time_passes(Simulation& simulation, std::uint64_t steps, BenchPicture& picture, DrawnFrames& frames) {
    BenchTimer timer(simulation.backend());
    const bool by_the_wall = simulation.backend().name() != "gpu";
    for (std::uint64_t i = 0; i < steps; ++i) {
        simulation.step();
        timer.begin();
        picture.draw(simulation, [&timer, by_the_wall](view::Pass) {
            if (by_the_wall) {
                glFinish();
            }
            timer.mark();
        });
        timer.end();
    }
    glFinish();
    for (const auto& span : timer.take()) {
        for (std::size_t pass = 0; pass < view::pass_count; ++pass) {
            frames.pass_ms[pass].push_back(span.at(pass));
        }
    }
}

// A grid that is used again is not built: then only so many substeps of a step move the bytes of the other stages.
double share_of_builds(const Schedule& schedule, const Settings& settings) {
    if (schedule.key_count == 0 || settings.grid_reuse == 1) {
        return 1.0;
    }
    const std::uint32_t builds = (settings.substeps + settings.grid_reuse - 1) / settings.grid_reuse;
    return static_cast<double>(builds) / settings.substeps;
}

void describe(const Simulation& simulation, BenchRow& row) {
    const Settings& settings = simulation.settings();
    const Schedule& schedule = simulation.whole_schedule();
    row.backend = simulation.backend().name();
    row.scene = simulation.scene().name;
    row.balls = settings.balls;
    row.substeps = settings.substeps;
    row.sort = setting_text(*find_setting("sort"), settings);
    row.grid_reuse = settings.grid_reuse;
    row.bytes_per_ball = bytes_per_ball(schedule);
    row.cell_table_bytes = bytes_of(schedule)[static_cast<std::size_t>(Slot::cell_ranges)];
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        const double share = static_cast<Stage>(stage) == Stage::collide ? 1.0 : share_of_builds(schedule, settings);
        row.stage_bytes[stage] = share * static_cast<double>(least_bytes(schedule, static_cast<Stage>(stage)));
    }
}

// The most that one dispatch of the stage moves: what fits into a cache may go faster than what does not.
std::size_t largest_dispatch(const Schedule& schedule, Stage stage) {
    std::size_t most = 0;
    for (const Dispatch& dispatch : schedule.dispatches) {
        most = dispatch.stage == stage ? std::max(most, least_bytes(dispatch, schedule)) : most;
    }
    return most;
}

void refuse_impossible(const Schedule& schedule, const measure::DeviceLimits& limits, BenchRow& row) {
    double bytes = 0.0;
    std::size_t at_once = 0;
    for (std::size_t i = 0; i < stage_count; ++i) {
        const auto stage = static_cast<Stage>(i);
        if (dispatches_of(schedule, stage) == 0) {
            continue;
        }
        const std::size_t most = largest_dispatch(schedule, stage);
        row.impossible[i] = measure::impossible(row.stage_ms[i], row.stages_wall_ms,
                                                static_cast<std::size_t>(row.stage_bytes[i]), most, limits);
        bytes += row.stage_bytes[i];
        at_once = std::max(at_once, most);
    }
    for (std::size_t i = 0; i < row.dispatches.size(); ++i) {
        const std::size_t least = least_bytes(schedule.dispatches[i], schedule);
        row.dispatches[i].impossible =
            measure::impossible(row.dispatches[i].ms, row.dispatches_wall_ms, least, least, limits);
    }
    if (!schedule.dispatches.empty()) {
        row.impossible_substep = measure::impossible(row.substep_ms, row.wall_ms * static_cast<double>(row.steps),
                                                     static_cast<std::size_t>(bytes), at_once, limits);
    }
}

}  // namespace

bool BenchRow::possible() const {
    const auto can_be = [](const DispatchTime& dispatch) { return dispatch.impossible.empty(); };
    return impossible_substep.empty() && std::ranges::all_of(impossible, &std::string::empty) &&
           std::ranges::all_of(dispatches, can_be);
}

BenchPicture::BenchPicture(const Paths& paths, view::Look look, int width, int height)
    : look_(look),
      renderer_(paths.shaders, view::load_model(paths.assets / "models" / "ball.obj")),
      framebuffer_(width, height) {}

void BenchPicture::draw(Simulation& simulation, const view::PassMark& mark) {
    framebuffer_.bind();
    renderer_.draw(home_picture(simulation, buffers_, look_, framebuffer_.width(), framebuffer_.height()), mark);
}

BenchRow measure_row(Simulation& simulation, const Checkpoint& start, const Settings& settings, const BenchPlan& plan,
                     const measure::DeviceLimits& limits) {
    begin_again(simulation, start, settings);
    BenchRow row;
    describe(simulation, row);
    const Schedule schedule = simulation.whole_schedule();
    row.crowding = measure::crowding_of(read_slot<vec4>(simulation.backend(), Slot::positions), schedule.grid);
    row.steps = warm_up(simulation, plan);
    begin_again(simulation, start, settings);
    const std::uint32_t missed_before = missed_so_far(simulation);
    time_substeps(simulation, row.steps, row);
    row.hash = hash_state(simulation.raw_state());
    row.missed = missed_so_far(simulation) - missed_before;  // not those of the way to rest
    begin_again(simulation, start, settings);
    time_stages(simulation, row.steps, row);
    if (plan.dispatches) {
        begin_again(simulation, start, settings);
        for (const Dispatch& dispatch : schedule.dispatches) {
            row.dispatches.push_back({dispatch.name, {}, {}});
        }
        time_dispatches(simulation, row.steps, row);
    }
    if (plan.picture != nullptr) {
        begin_again(simulation, start, settings);
        time_frames(simulation, row.steps, *plan.picture, row);
        begin_again(simulation, start, settings);
        time_passes(simulation, row.steps, *plan.picture, *row.frames);
    }
    refuse_impossible(schedule, limits, row);
    return row;
}

}  // namespace ballpit::app
