// A developer's tool, not run by the tests: the time of a scene's permutation of collide against a shader written by
// hand for that scene alone (tests/minimal), and of a whole substep against the one with every law compiled in and its
// coefficient zero. Rounds are interleaved, A B and B A in turn; the ratio is the median over rounds with a 95 %
// bootstrap interval. Both sides must give the same bits, or the exit code is 1.
#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>

#include "app/paths.h"
#include "app/report.h"
#include "core/random.h"
#include "core/simulation.h"
#include "gl/context.h"
#include "gl/error.h"
#include "gl/timer.h"
#include "gpu/gpu_backend.h"
#include "measure/statistics.h"
#include "support/law_scenes.h"

using namespace ballpit;

namespace {

constexpr double shortest_sample_ms = 0.5;  // shorter ones would measure the clock
constexpr double dense = 0.0072;            // m^3 a ball: close enough that each touches one or two
constexpr double sparse = 0.05;             // where balls do not touch each other: quick to fill
constexpr int settling_substeps = 50;

struct Options {
    int rounds = 200;
    std::vector<std::uint32_t> balls;
    std::string json;
};

struct Comparison {
    double a_ms = 0.0;
    double b_ms = 0.0;
    double ratio = 1.0;  // a / b
    std::array<double, 2> interval{};
    bool same_bits = false;
};

// The scene in a box that is as full at any count, without diagnostics.
Scene sized(Scene scene) {
    const double half =
        std::max(0.2, 0.5 * std::cbrt((scene.settings.laws.contact ? dense : sparse) * scene.settings.balls));
    scene.half_extent = dvec3(half);
    scene.fill->region = {dvec3(-half), dvec3(half)};
    scene.settings.laws.diagnostics = false;
    scene.settings.sorted_copies = false;  // what is written by hand reads the state where it is
    return scene;
}

// Every law, with a coefficient that changes nothing. Walls that swing by less than a float can tell do not move.
Settings everything_on(Settings settings) {
    const Laws laws = settings.laws;
    if (!laws.gravity) {
        settings.gravity = dvec3(0.0);
    }
    if (!laws.contact) {
        settings.stiffness = 0.0;
    }
    if (!laws.restitution) {
        settings.restitution = 1.0;
    }
    settings.drag = 0.0;
    settings.shake_amplitude = dvec3(1e-300);
    for (const LawInfo& law : law_table()) {
        settings.laws.*law.member = true;
    }
    settings.laws.compensated = false;  // has no coefficient: it is there to change bits
    return settings;
}

// A simulation on the GPU, settled, with its backend at hand.
struct Run {
    Run(const Scene& scene, const Settings& settings, const std::filesystem::path& shaders)
        : backend(new gpu::GpuBackend(shaders)),
          simulation(scene, settings, 1, std::unique_ptr<gpu::GpuBackend>(backend)) {
        for (int i = 0; i < settling_substeps; ++i) {
            simulation.substep();
        }
        backend->finish();
    }

    std::array<Bytes, 2> state() { return {backend->read(Slot::positions), backend->read(Slot::velocities)}; }

    gpu::GpuBackend* backend;
    Simulation simulation;
};

// One program for collide, on the buffers of a run.
class Collider {
public:
    Collider(Run& run, gl::Program program) : run_(run), program_(std::move(program)), params_(program_) {}

    /// `repeats` times from the same state, or on and on where it works in place.
    void dispatch(int repeats) {
        const Dispatch& collide = run_.simulation.schedule().dispatches.back();
        for (const std::vector<Slot>* slots : {&collide.reads, &collide.writes}) {
            for (const Slot slot : *slots) {
                run_.backend->buffer_for_drawing(slot).bind_base(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(slot));
            }
        }
        program_.use();
        params_.bind(narrowed<float>(run_.simulation.params()));
        for (int i = 0; i < repeats; ++i) {
            glDispatchCompute(collide.groups.x, collide.groups.y, 1);
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        }
    }

    std::array<Bytes, 2> result() {
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        const bool in_place = run_.simulation.schedule().in_place;
        return {run_.backend->read(in_place ? Slot::positions : Slot::next_positions),
                run_.backend->read(in_place ? Slot::velocities : Slot::next_velocities)};
    }

private:
    Run& run_;
    gl::Program program_;
    gpu::ParamsBlock params_;
};

using Sample = std::function<void()>;

std::array<double, 2> bootstrap_interval(const std::vector<double>& ratios) {
    constexpr std::uint64_t resamples = 2000;
    std::vector<double> medians;
    for (std::uint64_t i = 0; i < resamples; ++i) {
        std::vector<double> drawn;
        for (std::uint64_t k = 0; k < ratios.size(); ++k) {
            const double place = random_unit(1, i, k) * static_cast<double>(ratios.size());
            drawn.push_back(ratios[std::min(ratios.size() - 1, static_cast<std::size_t>(place))]);
        }
        medians.push_back(measure::median(std::move(drawn)));
    }
    return {measure::quantile(medians, 0.025), measure::quantile(medians, 0.975)};
}

double sample_ms(const Sample& sample) {
    gl::SpanTimer timer;
    timer.begin();
    sample();
    timer.mark(0);
    timer.end();
    glFinish();
    const auto spans = timer.take();
    return spans.empty() ? 0.0 : spans.front().front().ms;
}

// Dispatches, or substeps, in a sample.
int repeats_for(const Sample& once) {
    once();
    const double ms = std::max({sample_ms(once), sample_ms(once), 1e-4});
    return std::clamp(static_cast<int>(std::ceil(shortest_sample_ms / ms)), 1, 500);
}

Comparison interleaved(const Sample& a, const Sample& b, int rounds, int repeats) {
    gl::SpanTimer timer;
    for (int round = 0; round < rounds; ++round) {
        timer.begin();
        for (const int which : {round % 2, 1 - round % 2}) {
            (which == 0 ? a : b)();
            timer.mark(which);
        }
        timer.end();
        glFinish();  // seconds of work in the queue are more than some systems let a device have
    }
    std::array<std::vector<double>, 2> ms;
    std::vector<double> ratios;
    for (const gl::SpanTimer::Span& span : timer.take()) {
        std::array<double, 2> both{};
        for (const gl::SpanTimer::Part& part : span) {
            both.at(static_cast<std::size_t>(part.tag)) = part.ms / repeats;
        }
        ms[0].push_back(both[0]);
        ms[1].push_back(both[1]);
        ratios.push_back(both[0] / both[1]);
    }
    return {measure::median(ms[0]), measure::median(ms[1]), measure::median(ratios), bootstrap_interval(ratios), false};
}

Comparison against_by_hand(const Scene& scene, const std::string& shader, const std::filesystem::path& shaders,
                           int rounds) {
    Run run(scene, scene.settings, shaders);
    const Schedule& schedule = run.simulation.schedule();
    const auto compiled = [](const std::filesystem::path& folder, const std::string& file,
                             const std::vector<std::string_view>& defines) {
        return gl::Program(std::array{gl::ShaderStage{GL_COMPUTE_SHADER, gl::load_shader(folder, file, defines)}});
    };
    Collider ours(run, compiled(shaders, "collide.comp", gpu::defines_of(schedule.features)));
    Collider by_hand(run, compiled(shaders.parent_path() / "tests" / "minimal", shader + ".comp", {}));
    run.backend->run(schedule, run.simulation.params(), 0, schedule.dispatches.size() - 1);  // the grid
    const auto start = run.state();
    ours.dispatch(1);
    const auto ours_result = ours.result();
    run.backend->write(Slot::positions, start[0]);
    run.backend->write(Slot::velocities, start[1]);
    by_hand.dispatch(1);
    const bool same = ours_result == by_hand.result() && ours_result != start;
    const int repeats = repeats_for([&] { ours.dispatch(1); });
    Comparison comparison =
        interleaved([&] { ours.dispatch(repeats); }, [&] { by_hand.dispatch(repeats); }, rounds, repeats);
    comparison.same_bits = same;
    return comparison;
}

Comparison against_everything_on(const Scene& scene, const std::filesystem::path& shaders, int rounds) {
    Run minimal(scene, scene.settings, shaders);
    Run everything(scene, everything_on(scene.settings), shaders);
    const int repeats = repeats_for([&] { minimal.simulation.substep(); });
    const auto substeps = [repeats](Run& run) {
        for (int i = 0; i < repeats; ++i) {
            run.simulation.substep();
        }
    };
    Comparison comparison = interleaved([&] { substeps(everything); }, [&] { substeps(minimal); }, rounds, repeats);
    while (everything.simulation.step_count() < minimal.simulation.step_count() ||
           everything.simulation.substep_in_step() != minimal.simulation.substep_in_step()) {
        everything.simulation.substep();  // what finding the repeats took
    }
    comparison.same_bits = minimal.state() == everything.state();
    return comparison;
}

void print(const std::string& name, std::uint32_t balls, const char* other, const Comparison& c) {
    std::cout << std::left << std::setw(13) << name << std::right << std::setw(9) << balls << std::setw(24) << other
              << std::fixed << std::setprecision(5) << std::setw(12) << c.a_ms << std::setw(12) << c.b_ms
              << std::setprecision(4) << std::setw(10) << c.ratio << "  " << c.interval[0] << ".." << c.interval[1]
              << (c.same_bits ? "  same bits" : "  BITS DIFFER") << std::endl;
}

app::Json json_of(const Comparison& c) {
    return {{"a_ms", c.a_ms},
            {"b_ms", c.b_ms},
            {"ratio", c.ratio},
            {"ratio_95", {c.interval[0], c.interval[1]}},
            {"same_bits", c.same_bits}};
}

int run(const Options& options) {
    const std::filesystem::path shaders = app::find_paths().shaders;
    app::Report json(options.json);
    const gl::Context context({.title = "minimal_time", .width = 64, .height = 64, .visible = false, .debug = false});
    std::cout << context.renderer() << ", " << context.version() << ", " << options.rounds << " rounds\n"
              << "scene            balls                    a / b        a, ms       b, ms     ratio  95 %\n";
    struct Case {
        std::string name;
        Scene (*scene)(std::uint32_t);
        std::vector<std::uint32_t> balls;
    };
    const std::array cases = {Case{"free_fall", test::free_fall_scene, {65536, 1000000}},
                              Case{"elastic_gas", test::elastic_gas_scene, {65536}},
                              Case{"mono_pile", test::mono_pile_scene, {65536}}};
    app::Json report = {{"device", context.renderer()}, {"driver", context.version()}, {"rounds", options.rounds}};
    report["rows"] = app::Json::array();
    bool same_bits = true;
    for (const Case& one : cases) {
        for (const std::uint32_t balls : options.balls.empty() ? one.balls : options.balls) {
            const Scene scene = sized(one.scene(balls));
            const Comparison by_hand = against_by_hand(scene, one.name, shaders, options.rounds);
            print(one.name, balls, "collide / by hand", by_hand);
            const Comparison everything = against_everything_on(scene, shaders, options.rounds);
            print(one.name, balls, "every law on / substep", everything);
            same_bits = same_bits && by_hand.same_bits && everything.same_bits;
            report["rows"].push_back({{"scene", one.name},
                                      {"balls", balls},
                                      {"collide_against_by_hand", json_of(by_hand)},
                                      {"every_law_against_substep", json_of(everything)}});
        }
    }
    json.write(report.dump(2) + "\n");
    return same_bits ? 0 : 1;
}

int report(const std::exception& error, int code) {
    std::cerr << "minimal_time: " << error.what() << "\n";
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        Options options;
        CLI::App app("Times the shaders of three scenes against shaders written by hand", "minimal_time");
        app.add_option("--rounds", options.rounds, "Rounds of A B")->check(CLI::Range(1, 10000))->capture_default_str();
        app.add_option("--balls", options.balls, "Counts instead of the usual ones")->delimiter(',');
        app.add_option("--json", options.json, "Report as JSON to a file, or - for standard output");
        CLI11_PARSE(app, argc, argv);
        return run(options);
    } catch (const gl::ShaderError& error) {
        return report(error, 2);
    } catch (const gl::Error& error) {
        return report(error, 77);  // no OpenGL 4.3: CTest calls it skipped
    } catch (const std::exception& error) {
        return report(error, 2);
    }
}
