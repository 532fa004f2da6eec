// Throws broken and half-broken scene files at the parser: each must be a scene that can be built, or be refused in one
// sentence. A case is a pure function of seed and number, so whatever fails can be run again alone.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>

#include "core/error.h"
#include "core/scene_file.h"
#include "core/simulation.h"
#include "core/world.h"
#include "cpu/cpu_backend.h"
#include "support/scene_mutator.h"

using namespace ballpit;

namespace {

struct Arguments {
    std::uint64_t seed = 1;
    std::uint64_t first = 0;
    std::uint64_t cases = ~std::uint64_t{0};
    double seconds = 10.0;
    bool verbose = false;
};

struct Tally {
    std::uint64_t cases = 0;
    std::uint64_t accepted = 0;
    std::uint64_t simulated = 0;
};

constexpr const char* usage =
    "ballpit_scene_fuzz [--seconds S] [--cases N] [--seed S] [--first N] [--verbose]\n"
    "runs cases from number N on until one of both limits; --verbose names each before it runs\n";

Arguments parse(int count, char** values) {
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string option = values[i];
        if (option == "--verbose") {
            arguments.verbose = true;
            continue;
        }
        const char* value = i + 1 < count ? values[++i] : "";
        if (option == "--seconds") {
            arguments.seconds = std::strtod(value, nullptr);
        } else if (option == "--cases") {
            arguments.cases = std::strtoull(value, nullptr, 10);
        } else if (option == "--seed") {
            arguments.seed = std::strtoull(value, nullptr, 10);
        } else if (option == "--first") {
            arguments.first = std::strtoull(value, nullptr, 10);
        } else {
            std::cerr << usage;
            std::exit(2);
        }
    }
    return arguments;
}

[[noreturn]] void fail(const std::string& what) { throw std::logic_error(what); }

void expect(bool holds, const char* what) {
    if (!holds) {
        fail(what);
    }
}

bool is_finite(const vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

// One short line that begins with the file, whatever the file holds.
void check_sentence(const std::string& sentence) {
    expect(sentence.starts_with("s.json"), "the sentence does not begin with the file");
    expect(sentence.find(": expected ") != std::string::npos, "the sentence does not say what was expected");
    expect(sentence.find(", found ") != std::string::npos, "the sentence does not say what was found");
    expect(sentence.size() < 600, "the sentence is too long");
    for (const char c : sentence) {
        expect(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F, "the sentence has a control character");
    }
}

void check_settings(const Settings& settings) {
    Settings copy;
    for (const SettingInfo& info : setting_table()) {
        assign_setting(copy, info.key, setting_text(info, settings));  // throws where one is out of range
    }
    expect(copy == settings, "settings differ from their own text");
}

void check_world(const Scene& scene, std::uint32_t count) {
    const World world = make_world(scene, count, scene.fill ? scene.fill->seed : 0);
    expect(world.balls.count() == count, "the world has another number of balls");
    for (std::uint32_t i = 0; i < count; ++i) {
        const vec4& position = world.balls.positions[i];
        const vec4& velocity = world.balls.velocities[i];
        expect(is_finite(position) && is_finite(velocity), "a ball is not finite");
        expect(position.w > 0.0f && velocity.w > 0.0f, "a ball has no radius or no mass");
    }
}

// Only that it does not crash: a scene may be as unstable as it likes.
void simulate(const Scene& scene, std::uint32_t count) {
    Settings settings = scene.settings;
    settings.balls = count;
    try {
        Simulation simulation(scene, settings, 1, std::make_unique<cpu::CpuBackend<float>>());
        simulation.substep();
        simulation.substep();
    } catch (const InputError&) {  // no such scene on this device
    } catch (const DeviceError&) {
    }
}

void run_case(const std::string& text, std::uint64_t number, Tally& tally) {
    ++tally.cases;
    Scene scene;
    try {
        scene = parse_scene(text, "s.json");
    } catch (const InputError& error) {
        check_sentence(error.what());
        return;
    }
    const std::uint32_t most = number % 16 == 0 ? 1000u : 40u;
    const std::uint32_t count = std::min(scene.settings.balls, most);
    check_settings(scene.settings);
    check_world(scene, count);
    if (++tally.accepted % 16 == 0) {
        ++tally.simulated;
        simulate(scene, std::min(count, 64u));
    }
}

}  // namespace

int main(int count, char** values) {
    const Arguments arguments = parse(count, values);
    const std::filesystem::path source = BALLPIT_SOURCE_DIR;
    const test::SceneMutator mutator({source / "assets" / "scenes", source / "tests" / "scenes"});
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    Tally tally;
    while (tally.cases < arguments.cases && seconds() < arguments.seconds) {
        const std::uint64_t number = arguments.first + tally.cases;
        if (arguments.verbose) {
            std::cout << "case " << number << std::endl;  // flushed: it may be the last
        }
        const std::string text = mutator.text(arguments.seed, number);
        try {
            run_case(text, number, tally);
        } catch (const std::exception& error) {
            std::ofstream("scene_fuzz_failure.json", std::ios::binary) << text;
            std::cerr << "seed " << arguments.seed << ", case " << number << ": " << error.what()
                      << "\nthe text is in scene_fuzz_failure.json\n";
            return 1;
        }
        if (tally.cases % 100000 == 0) {
            std::cout << tally.cases << " cases" << std::endl;
        }
    }
    std::cout << tally.cases << " cases from " << mutator.corpus_size() << " files, " << tally.accepted
              << " of them scenes, " << tally.simulated << " of those simulated\n";
    if (tally.cases > 1000 && tally.accepted < tally.cases / 50) {
        std::cerr << "hardly any case is a scene: worlds are not tried\n";
        return 1;
    }
    return 0;
}
