#include "support/stepping.h"

#include <array>
#include <functional>
#include <map>

#include "core/stepper.h"
#include "support/catch.h"

namespace ballpit::test {

namespace {

constexpr std::size_t budget = 1u << 20;

using AllSlots = std::array<Bytes, slot_count>;

AllSlots all_slots(Backend& backend) {
    AllSlots slots;
    for (std::size_t i = 0; i < slot_count; ++i) {
        slots[i] = backend.read(static_cast<Slot>(i));
    }
    return slots;
}

// Every position of the first `steps` steps with its bytes, by single dispatches.
std::map<Position, AllSlots> straight_run(Stepper& stepper, Simulation& simulation, std::uint64_t steps) {
    std::map<Position, AllSlots> seen;
    while (simulation.step_count() < steps) {
        stepper.forward(StepUnit::pass);
        seen[stepper.position()] = all_slots(simulation.backend());
    }
    return seen;
}

void check_bytes(const std::map<Position, AllSlots>& seen, const Position& at, Backend& backend) {
    const auto expected = seen.find(at);
    if (expected == seen.end()) {
        REQUIRE(at == Position{});  // the start: nothing ran before it
        return;
    }
    const AllSlots now = all_slots(backend);
    for (std::size_t i = 0; i < slot_count; ++i) {
        INFO("slot " << slot_names[i] << " at step " << at.moment.step << ", substep " << at.moment.substep
                     << ", dispatch " << at.dispatch);
        const bool same = now[i] == expected->second[i];
        CHECK(same);
    }
}

// What somebody does, given the scene as it is now.
using Doing = std::function<Change(const Simulation&)>;

template <class Edit>
Doing settings_edit(Edit edit) {
    return [edit](const Simulation& simulation) -> Change {
        Settings settings = simulation.settings();
        edit(settings);
        return settings;
    };
}

// What is done at one moment, one after the other, moment by moment. There and back at the same moment leaves its
// trace, too: velocities have been brought to the time of positions.
std::vector<std::vector<Doing>> all_doings() {
    const auto edit = [](auto what) { return std::vector<Doing>{settings_edit(what)}; };
    return {
        edit([](Settings& s) {
            s.walls_low = {0.2, 0.0, 0.01};
        }),
        edit([](Settings& s) { s.laws.shake = true; }),
        {[](const Simulation&) -> Change {
            return AddBalls{{{{0.3, 0.1, 0.9}, {0, 0, -5}, 0.05, 20.0, std::nullopt},
                             {{-0.3, 0.1, 0.9}, {0, 3, 0}, 0.25, 1.0, std::nullopt}}};
        }},
        edit([](Settings& s) {
            s.pull = Pull{41, {0.5, 0.5, 0.5}};
        }),
        edit([](Settings& s) {
            s.pull->target = {-0.5, 0.5, 0.5};
        }),
        {settings_edit([](Settings& s) { s.laws.drag = false; }),
         settings_edit([](Settings& s) { s.laws.drag = true; }), settings_edit([](Settings& s) { s.drag = 3.0; }),
         settings_edit([](Settings& s) { s.drag = 0.5; })},
        edit([](Settings& s) { s.laws = parse_laws("gravity"); }),  // in place from here
        edit([](Settings& s) {
            s.walls_high = {0.0, 0.0, -0.3};
        }),
        edit([](Settings& s) { s.laws = parse_laws("drag,walls,restitution,shake"); }),
        edit([](Settings& s) { s.balls = 20; }),
        edit([](Settings& s) { s.laws = parse_laws("gravity,contact,walls,ball_restitution,diagnostics"); }),
        edit([](Settings& s) { s.pull.reset(); }),
        {settings_edit([](Settings& s) {
             s.pull = Pull{3, {0.5, 0.5, 0.5}};
         }),
         settings_edit([](Settings& s) { s.pull.reset(); })},
        edit([](Settings& s) { s.integrator = Integrator::velocity_verlet; }),
        edit([](Settings& s) { s.neighbours = NeighbourSearch::brute_force; }),
        {[](const Simulation&) -> Change {
            return AddBalls{{{{0.0, 0.0, 0.5}, {0, 0, -5}, 0.1, 1.0, std::nullopt}}};
        }},
        edit([](Settings& s) { s.balls = 45; }),
        edit([](Settings& s) { s.walls_low = dvec3(0.0); }),
        edit([](Settings& s) { s.laws.compensated = true; }),
        edit([](Settings& s) { s.laws = parse_laws("gravity,drag,walls,compensated"); }),  // in place from here
        {[](const Simulation&) -> Change {
            return AddBalls{{{{0.1, 0.0, 0.5}, {0, 0.3, -5}, 0.1, 1.0, std::nullopt}}};
        }},
        edit([](Settings& s) { s.balls = 40; }),
        edit([](Settings& s) {
            s.laws.contact = s.laws.restitution = true;
            s.neighbours = NeighbourSearch::grid;
        }),
        edit([](Settings& s) { s.laws.compensated = false; }),
        edit([](Settings& s) {
            s.grid_reuse = 2;
            s.substeps = 5;
        }),
        {settings_edit([](Settings& s) { s.gravity.x = 1.0; }), settings_edit([](Settings& s) { s.gravity.x = 0.0; })},
        edit([](Settings& s) { s.laws.diagnostics = false; }),
        edit([](Settings& s) { s.cell_factor = 1.5; }),
        edit([](Settings& s) { s.laws.diagnostics = true; }),
    };
}

}  // namespace

Simulation stepping_simulation(std::unique_ptr<Backend> backend, SortMethod sort) {
    Scene scene;
    scene.name = "stepping";
    scene.half_extent = dvec3(1.0);
    scene.settings.laws = parse_laws("gravity,drag,contact,restitution,walls,diagnostics");
    scene.fill = Fill{40, {0.1, 0.15}, 1000.0, 1.0, {dvec3(-0.9), dvec3(0.9)}, 7};
    scene.balls.push_back({dvec3(0.0), dvec3(0.0), 0.2, 5.0, 0.5});
    scene.settings.balls = 41;
    scene.settings.substeps = 2;
    scene.settings.stiffness = 1e4;
    scene.settings.sort = sort;
    return {scene, scene.settings, 7, std::move(backend)};
}

void check_every_position(Simulation& simulation) {
    Stepper stepper(simulation, budget);
    const auto seen = straight_run(stepper, simulation, 2);
    REQUIRE(seen.size() > 30);  // a counting sort has few dispatches
    for (const auto& [position, bytes] : seen) {
        for (const StepUnit unit : {StepUnit::pass, StepUnit::stage, StepUnit::substep, StepUnit::step}) {
            stepper.go_to(position);
            REQUIRE(stepper.position() == position);
            check_bytes(seen, position, simulation.backend());
            stepper.back(unit);
            CHECK(stepper.position() < position);
            check_bytes(seen, stepper.position(), simulation.backend());
            stepper.forward(unit);
            check_bytes(seen, stepper.position(), simulation.backend());
        }
    }
    CHECK_FALSE(stepper.divergence());
}

void check_changes_at_every_position(Simulation& simulation) {
    Stepper stepper(simulation, budget);
    std::map<Position, AllSlots> seen;
    const auto doings = all_doings();
    for (const std::vector<Doing>& at_once : doings) {
        for (const Doing& doing : at_once) {
            stepper.change(doing(simulation));
        }
        seen[stepper.position()] = all_slots(simulation.backend());
        const std::uint64_t until = simulation.step_count() + 2;
        while (simulation.step_count() < until) {
            stepper.forward(StepUnit::pass);
            seen[stepper.position()] = all_slots(simulation.backend());
        }
    }
    REQUIRE(seen.size() > 10 * doings.size());
    const Position end = stepper.position();
    const Box box = simulation.box();
    while (stepper.position() > Position{{0, 0}, 1}) {
        stepper.back(StepUnit::pass);
        check_bytes(seen, stepper.position(), simulation.backend());
    }
    std::size_t index = 0;
    for (const auto& [position, bytes] : seen) {
        if (++index % 7 == 0) {
            stepper.go_to(end);
            stepper.go_to(position);
            check_bytes(seen, position, simulation.backend());
        }
    }
    stepper.go_to({});
    stepper.go_to(end);
    check_bytes(seen, end, simulation.backend());
    CHECK(simulation.box() == box);
    simulation.backend().finish();
    stepper.update();
    CHECK_FALSE(stepper.divergence());
}

void check_long_way(Simulation& simulation, std::uint64_t steps) {
    Stepper stepper(simulation, budget);
    std::map<std::uint64_t, std::uint64_t> hashes;
    const Settings start = simulation.settings();
    for (std::uint64_t step = 0; step < steps; ++step) {
        Settings settings = simulation.settings();
        settings.gravity.x = step % 50 < 25 ? 3.0 : -3.0;
        settings.balls = step < steps / 2 ? 41 : 30;
        settings.substeps = step % 100 < 50 ? 2 : 3;
        stepper.change(settings);
        stepper.forward(StepUnit::step);
        hashes[simulation.step_count()] = hash_state(simulation.raw_state());
    }
    CHECK(stepper.timeline().used_bytes() <= budget);
    for (std::uint64_t step = steps; step > 0; step -= 1 + step / 7) {
        while (simulation.step_count() > step) {
            stepper.back(StepUnit::step);
        }
        INFO("step " << step);
        REQUIRE(hash_state(simulation.raw_state()) == hashes.at(step));
    }
    stepper.go_to({});
    CHECK(simulation.settings().balls == 41);
    CHECK(simulation.time() == 0.0);
    stepper.go_to({{steps, 0}, 0});
    CHECK(hash_state(simulation.raw_state()) == hashes.at(steps));
    simulation.backend().finish();
    stepper.update();
    simulation.backend().finish();
    stepper.update();
    CHECK(stepper.hash(steps) == hashes.at(steps));
    CHECK_FALSE(stepper.divergence());
    stepper.go_to({});
    CHECK(simulation.settings() != start);  // the first change took hold before the first step
}

}  // namespace ballpit::test
