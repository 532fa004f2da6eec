// State hashes of every shipped scene, as it is and with each integrator, law and way to compute, on the mirror, on all
// processors and in double: one line each. `./run determinism` compares the output of builds that may differ in nothing
// else than how they were compiled.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "cpu/threaded_backend.h"
#include "support/scenes.h"

using namespace ballpit;

namespace {

constexpr std::uint32_t most_balls = 150;  // unoptimised builds take their time
constexpr int steps = 10;

struct Variant {
    std::string name;
    Settings settings;
};

std::vector<Variant> variants_of(const Settings& settings) {
    std::vector<Variant> variants{{"as it is", settings}};
    const auto add = [&](std::string name, const std::function<void(Settings&)>& change) {
        Settings changed = settings;
        change(changed);
        if (changed != settings) {
            variants.push_back({std::move(name), changed});
        }
    };
    for (std::size_t i = 0; i < integrator_names.size(); ++i) {
        add("integrator " + std::string(integrator_names[i]),
            [i](Settings& changed) { changed.integrator = static_cast<Integrator>(i); });
    }
    for (const LawInfo& law : law_table()) {
        add((settings.laws.*law.member ? "without " : "with ") + std::string(law.key),
            [&law](Settings& changed) { changed.laws.*law.member = !(changed.laws.*law.member); });
    }
    add("brute force", [](Settings& changed) { changed.neighbours = NeighbourSearch::brute_force; });
    add("bitonic", [](Settings& changed) { changed.sort = SortMethod::bitonic; });
    add("one grid for four substeps", [](Settings& changed) { changed.grid_reuse = 4; });
    add("semi-implicit dashpot", [](Settings& changed) { changed.dashpot = DashpotMethod::semi_implicit; });
    add("forces not limited", [](Settings& changed) { changed.limit_force = false; });
    add("walls that move", [](Settings& changed) { changed.walls_low.x += 0.01; });
    return variants;
}

std::uint64_t hash_of(const Scene& scene, const Settings& settings, std::unique_ptr<Backend> backend) {
    Simulation simulation(scene, settings, test::seed_of(scene), std::move(backend));
    for (int i = 0; i < steps; ++i) {
        simulation.step();
    }
    return hash_state(simulation.raw_state());
}

// False: threads do not give the mirror's bits.
bool print_hashes(std::string_view name) {
    bool same = true;
    const Scene scene = test::shipped_scene(name);
    Settings settings = scene.settings;
    settings.balls = std::min(settings.balls, std::max(most_balls, static_cast<std::uint32_t>(scene.balls.size())));
    for (const Variant& variant : variants_of(settings)) {
        const std::uint64_t mirror = hash_of(scene, variant.settings, std::make_unique<cpu::CpuBackend<float>>());
        const std::uint64_t threads = hash_of(scene, variant.settings, std::make_unique<cpu::ThreadedBackend>(3));
        const std::uint64_t reference = hash_of(scene, variant.settings, std::make_unique<cpu::CpuBackend<double>>());
        std::printf("%-22s %-28s %016llx %016llx%s\n", std::string(name).c_str(), variant.name.c_str(),
                    static_cast<unsigned long long>(mirror), static_cast<unsigned long long>(reference),
                    threads == mirror ? "" : "  threads have other bits");
        same = same && threads == mirror;
    }
    return same;
}

}  // namespace

int main() {
    bool same = true;
    try {
        for (const std::string_view name : test::shipped_scene_names) {
            same = print_hashes(name) && same;
        }
    } catch (const InputError& error) {
        std::fprintf(stderr, "ballpit_scene_hashes: %s\n", error.what());
        return 2;
    }
    return same ? 0 : 1;
}
