// Changed while running, run twice, and refused before.
#include <array>
#include <cmath>
#include <exception>

#include "core/error.h"
#include "core/scene_file.h"
#include "measure/extreme_rows.h"

namespace ballpit::measure {

namespace {

Scene heap(std::uint32_t balls) {
    Scene scene = extreme_scene("gravity,contact,restitution,walls", 1.0);
    scene.settings.restitution = 0.5;
    scene.settings.stiffness = 5e3;
    fill_region(scene, balls, {0.06, 0.1}, 1.0, dvec3(-1.0), dvec3(1.0));
    return scene;
}

std::string refusal(const std::string& laws, const std::string& ball) {
    const std::string text =
        R"({"name":"n","box":{"half_extent":[1,1,1]},"laws":{)" + laws + R"(},"balls":[)" + ball + "]}";
    try {
        parse_scene(text, "scene");
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

struct Refused {
    const char* what;
    const char* laws;
    const char* ball;
};

template <class Alter>
void change(ExtremeTrial& trial, Simulation& simulation, const std::string& what, const Alter& alter) {
    Settings settings = simulation.settings();
    alter(settings);
    const double before = simulation.time();
    simulation.change(settings);
    trial.require(std::abs(simulation.time() - before) < 1e-12, what + ": the clock jumps");
    run_steps(simulation, 10);
    const BallState state = simulation.raw_state();
    trial.expect(all_finite(state) && state.count() == settings.balls, what);
}

}  // namespace

void impossible_input(ExtremeTrial& trial) {
    constexpr const char* ball = R"({"position":[0,0,0],"radius":0.1,"mass":1})";
    for (const Refused& refused : std::array{
             Refused{"mass 0", "", R"({"position":[0,0,0],"radius":0.1,"mass":0})"},
             Refused{"mass -1", "", R"({"position":[0,0,0],"radius":0.1,"mass":-1})"},
             Refused{"radius 0", "", R"({"position":[0,0,0],"radius":0,"mass":1})"},
             Refused{"drag -1", R"("drag":-1)", ball}, Refused{"stiffness -1", R"("contact":{"stiffness":-1})", ball},
             Refused{"restitution 2", R"("contact":{"stiffness":1,"restitution":2})", ball},
             Refused{"gravity 1e999", R"("gravity":[0,0,1e999])", ball},
             Refused{"a ball beyond the wall", "", R"({"position":[0,0,6],"radius":0.1,"mass":1})"}}) {
        const std::string sentence = refusal(refused.laws, refused.ball);
        trial.expect(sentence.find("expected") != std::string::npos, std::string(refused.what) + " refused");
    }
    trial.expect(refusal("", ball).empty(), "the ball that they spoil is taken");
}

void order_of_neighbours(ExtremeTrial& trial) {
    const Scene scene = heap(300);
    Simulation first = trial.start(scene);
    Simulation second = trial.start(scene);
    run_steps(first, 60);
    run_steps(second, 60);
    trial.at_least("contacts in the pile", totals_of(first).contacts, 100.0);
    trial.expect(hash_of(first) == hash_of(second), "after 480 substeps twice the same bits");
}

void changed_while_running(ExtremeTrial& trial) {
    Simulation simulation = trial.start(heap(150));
    run_steps(simulation, 10);
    change(trial, simulation, "150 balls become 401, all finite", [](Settings& s) { s.balls = 401; });
    change(trial, simulation, "then 3", [](Settings& s) { s.balls = 3; });
    change(trial, simulation, "then none", [](Settings& s) { s.balls = 0; });
    change(trial, simulation, "then 200", [](Settings& s) { s.balls = 200; });
    change(trial, simulation, "cells x 4", [](Settings& s) { s.cell_factor = 4.0; });
    change(trial, simulation, "dt / 3", [](Settings& s) { s.dt /= 3.0; });
    change(trial, simulation, "brute force", [](Settings& s) { s.neighbours = NeighbourSearch::brute_force; });
    change(trial, simulation, "without contact", [](Settings& s) { s.laws.contact = false; });
    change(trial, simulation, "no law at all", [](Settings& s) { s.laws = Laws{}; });
    const Scene other = heap(65);
    simulation.load(other, other.settings, 7);
    run_steps(simulation, 10);
    Simulation fresh = trial.start(other);
    fresh.load(other, other.settings, 7);
    run_steps(fresh, 10);
    trial.expect(hash_of(simulation) == hash_of(fresh), "another scene runs as if it had been the first");
}

}  // namespace ballpit::measure
