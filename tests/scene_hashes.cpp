// State hashes of every shipped scene, as it is and with each integrator, law and way to compute, on the mirror and in
// double: one line each. `./run determinism` compares the output of builds that may differ in nothing else than how
// they were compiled.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/simulation.h"
#include "cpu/cpu_backend.h"
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

template <class Real>
std::uint64_t hash_of(const Scene& scene, const Settings& settings) {
    Simulation simulation(scene, settings, test::seed_of(scene), std::make_unique<cpu::CpuBackend<Real>>());
    for (int i = 0; i < steps; ++i) {
        simulation.step();
    }
    return hash_state(simulation.raw_state());
}

void print_hashes(std::string_view name) {
    const Scene scene = test::shipped_scene(name);
    Settings settings = scene.settings;
    settings.balls = std::min(settings.balls, std::max(most_balls, static_cast<std::uint32_t>(scene.balls.size())));
    for (const Variant& variant : variants_of(settings)) {
        std::printf("%-22s %-28s %016llx %016llx\n", std::string(name).c_str(), variant.name.c_str(),
                    static_cast<unsigned long long>(hash_of<float>(scene, variant.settings)),
                    static_cast<unsigned long long>(hash_of<double>(scene, variant.settings)));
    }
}

}  // namespace

int main() {
    try {
        for (const std::string_view name : test::shipped_scene_names) {
            print_hashes(name);
        }
    } catch (const InputError& error) {
        std::fprintf(stderr, "ballpit_scene_hashes: %s\n", error.what());
        return 2;
    }
    return 0;
}
