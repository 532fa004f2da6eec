#include "support/zero_laws.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/simulation.h"
#include "support/catch.h"
#include "support/law_scenes.h"

namespace ballpit::test {

namespace {

constexpr std::uint32_t balls = 100;
constexpr int steps = 1000;

// A scene, how it is changed to have one thing more, and the bit of its programs that shows that it has.
struct ZeroLaw {
    std::string name;
    std::string base;
    std::function<void(Settings&)> add;
    Feature shows_as;
    double half_extent = 0.5;  // m
};

Scene base_scene(const ZeroLaw& law, Integrator integrator, NeighbourSearch neighbours) {
    Scene scene = scene_with(law.base, balls);
    scene.half_extent = dvec3(law.half_extent);
    scene.fill->region = {dvec3(-0.5), dvec3(0.5)};
    scene.settings.dt = 0.002;
    scene.settings.substeps = 1;
    scene.settings.integrator = integrator;
    scene.settings.neighbours = neighbours;
    return scene;
}

void add_everything(Settings& settings) {
    for (const LawInfo& info : law_table()) {
        settings.laws.*info.member = true;
    }
    settings.laws.compensated = false;  // it has no coefficient that could be 0
    settings.drag = 0.0;
    settings.shake_amplitude = dvec3(1e-300);  // less than a float can tell, and yet the walls' velocity is compiled in
}

// "pile" stands for gravity, contact, restitution and walls.
const std::vector<ZeroLaw>& zero_laws() {
    static const std::string pile = "gravity,contact,restitution,walls";
    static const std::vector<ZeroLaw> laws = {
        {"no gravity", "contact,walls",
         [](Settings& s) {
             s.laws.gravity = true;
             s.gravity = dvec3(0.0);
         },
         Feature::gravity},
        {"no drag", pile,
         [](Settings& s) {
             s.laws.drag = true;
             s.drag = 0.0;
         },
         Feature::drag},
        {"soft contacts", "gravity,drag",
         [](Settings& s) {
             s.laws.contact = true;
             s.stiffness = 0.0;
         },
         Feature::contact},
        {"soft contacts with a dashpot", "gravity,drag",
         [](Settings& s) {
             s.laws.contact = s.laws.restitution = true;
             s.stiffness = 0.0;
         },
         Feature::dashpot},
        {"nothing lost", "gravity,contact,walls",
         [](Settings& s) {
             s.laws.restitution = true;
             s.restitution = 1.0;
         },
         Feature::limit_force},
        {"nothing lost, by a semi-implicit dashpot", "gravity,contact,walls",
         [](Settings& s) {
             s.laws.restitution = true;
             s.restitution = 1.0;
             s.dashpot = DashpotMethod::semi_implicit;
         },
         Feature::semi_implicit},
        {"nothing lost, and contacts may pull", "gravity,contact,walls",
         [](Settings& s) {
             s.laws.restitution = true;
             s.restitution = 1.0;
             s.limit_force = false;
         },
         Feature::dashpot},
        {"soft walls", "gravity,drag",
         [](Settings& s) {
             s.laws.walls = true;
             s.stiffness = 0.0;
         },
         Feature::walls},
        {"walls far away", "contact,restitution", [](Settings& s) { s.laws.walls = true; }, Feature::walls, 20.0},
        {"a box that hardly swings", pile,
         [](Settings& s) {
             s.laws.shake = true;
             s.shake_amplitude = dvec3(1e-300);
         },
         Feature::moving_walls},
        {"a box that swings by nothing", pile,
         [](Settings& s) {
             s.laws.shake = s.laws.diagnostics = true;
             s.shake_amplitude = dvec3(0.0);
         },
         Feature::diagnostics},
        {"radii of their own", pile, [](Settings& s) { s.laws.unequal_radii = true; }, Feature::unequal_radii},
        {"masses of their own", pile, [](Settings& s) { s.laws.unequal_masses = true; }, Feature::unequal_masses},
        {"restitutions of their own", pile, [](Settings& s) { s.laws.ball_restitution = true; },
         Feature::ball_restitution},
        {"diagnostics", pile, [](Settings& s) { s.laws.diagnostics = true; }, Feature::diagnostics},
        {"everything beside a pile", pile, add_everything, Feature::moving_walls},
        {"everything beside free fall", "gravity",
         [](Settings& s) {
             add_everything(s);
             s.stiffness = 0.0;
         },
         Feature::ball_restitution},
    };
    return laws;
}

struct Outcome {
    std::uint64_t hash;
    bool finite;
};

Outcome outcome_of(Simulation& simulation) {
    for (int i = 0; i < steps; ++i) {
        simulation.step();
    }
    const BallState state = simulation.raw_state();
    const bool finite =
        std::ranges::all_of(state.positions, [](const vec4& p) { return std::isfinite(p.x + p.y + p.z); });
    return {hash_state(state), finite};
}

}  // namespace

void zero_laws_change_no_bit(const MakeBackend& make_backend, Integrator integrator, NeighbourSearch neighbours) {
    std::map<std::pair<std::string, double>, std::uint64_t> without;  // runs that several laws are compared with
    for (const ZeroLaw& law : zero_laws()) {
        CAPTURE(law.name, integrator_names[static_cast<std::size_t>(integrator)]);
        const Scene scene = base_scene(law, integrator, neighbours);
        const auto [base, is_new] = without.try_emplace({law.base, law.half_extent});
        if (is_new) {
            Simulation plain(scene, scene.settings, 1, make_backend());
            REQUIRE_FALSE(plain.features().has(law.shows_as));
            const Outcome outcome = outcome_of(plain);
            REQUIRE(outcome.finite);
            base->second = outcome.hash;
        }
        Settings settings = scene.settings;
        law.add(settings);
        Simulation added(scene, settings, 1, make_backend());
        REQUIRE(added.features().has(law.shows_as));
        CHECK(outcome_of(added).hash == base->second);
    }
}

}  // namespace ballpit::test
