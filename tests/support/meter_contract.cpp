#include "support/meter_contract.h"

#include <cmath>
#include <string>

#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "measure/pairs.h"
#include "support/catch.h"
#include "support/law_scenes.h"

namespace ballpit::test {

namespace {

std::vector<TaggedReading> arrived(Backend& backend, std::size_t count) {
    std::vector<TaggedReading> all;
    for (int i = 0; i < 1000 && all.size() < count; ++i) {
        backend.finish();
        for (const TaggedReading& reading : backend.take_readings()) {
            all.push_back(reading);
        }
    }
    REQUIRE(all.size() == count);
    return all;
}

// Sums of the sizes of what is added up: rounding is a share of those, whatever cancels.
struct Scale {
    double potential = 0.0;
    double elastic = 0.0;
    double heat = 0.0;  // of contacts and of walls
    double wall_work = 0.0;
    double hand = 0.0;
    double momentum = 0.0;
    double angular = 0.0;
    double contacts = 0.0;
    double force = 0.0;
};

// A contact's force is known to a few ulps of k times the radii, because the overlap is; k D, spring and dashpot.
void add_contact(Scale& scale, const SubstepParams<double>& p, double diameter, double speed, double mass) {
    const double force = p.stiffness * diameter + 4.0 * std::sqrt(p.stiffness * mass) * speed;
    scale.elastic += p.stiffness * diameter * diameter;
    scale.heat += force * speed;
    scale.force += force;
    scale.contacts += 1.0;
}

Scale scale_of(const BallState& state, const SubstepParams<double>& p, Features features) {
    Scale scale;
    const double walls = glm::length(p.lower_velocity) + glm::length(p.upper_velocity);
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
        const dvec3 x(state.positions[i]);
        const dvec3 v(state.velocities[i]);
        const auto mass = static_cast<double>(state.velocities[i].w);
        const auto radius = static_cast<double>(state.positions[i].w);
        // Synchronising adds what forces and gravity do in a substep; a margin for that.
        const double speed = 2.0 * glm::length(v) + 0.2;
        scale.potential += mass * glm::length(p.gravity) * glm::length(x);
        scale.momentum += mass * speed;
        scale.angular += mass * speed * (glm::length(x) + glm::length(p.box_upper - p.box_lower));
        if (features.has(Feature::pull) && i == p.pull_ball) {
            const double pull = p.pull_rate * p.pull_rate * glm::length(p.pull_target - x) + 2.0 * p.pull_rate * speed;
            scale.hand += mass * pull * speed;
        }
        for (int axis = 0; features.has(Feature::walls) && axis < 3; ++axis) {
            if (x[axis] - radius < p.box_lower[axis] || x[axis] + radius > p.box_upper[axis]) {
                add_contact(scale, p, 2.0 * radius, speed + walls, mass);
                scale.wall_work += scale.force * walls;
            }
        }
    }
    for (const measure::Pair& pair : measure::touching_pairs(state.positions)) {
        const double reach = static_cast<double>(state.positions[pair.a].w + state.positions[pair.b].w);
        const double speed = 2.0 * glm::length(dvec3(state.velocities[pair.a]) - dvec3(state.velocities[pair.b])) + 0.4;
        add_contact(scale, p, reach, speed, static_cast<double>(state.velocities[pair.a].w));
    }
    return scale;
}

// Terms are off by up to some 30 ulps (docs/accuracy.md), their sum by 16 more.
constexpr double allowed = 48.0 * 0x1p-24;

void check_near(const char* name, double device, double mirror, double scale) {
    INFO(name << ": " << device << ", mirror " << mirror << ", may differ by " << allowed * scale);
    CHECK(std::abs(device - mirror) <= allowed * scale);
}

void check_agree(const MeterReading& a, const MeterReading& b, const Scale& s) {
    check_near("kinetic", a.kinetic, b.kinetic, b.kinetic + s.heat * 1e-3);
    check_near("potential", a.potential, b.potential, s.potential);
    check_near("elastic", a.elastic, b.elastic, s.elastic);
    check_near("contact heat", a.contact_heat, b.contact_heat, s.heat);
    check_near("wall heat", a.wall_heat, b.wall_heat, s.heat);
    check_near("wall work", a.wall_work, b.wall_work, s.wall_work);
    check_near("hand work", a.hand_work, b.hand_work, s.hand);
    check_near("floor force", a.floor_force, b.floor_force, s.force);
    check_near("mass", a.mass, b.mass, b.mass);
    for (int axis = 0; axis < 3; ++axis) {
        check_near("momentum", a.momentum[axis], b.momentum[axis], s.momentum);
        check_near("angular momentum", a.angular_momentum[axis], b.angular_momentum[axis], s.angular);
    }
    check_near("overlap shares", a.overlap_shares, b.overlap_shares, s.contacts);
    CHECK(a.contact_ends == b.contact_ends);
    CHECK(a.wall_contacts == b.wall_contacts);
    check_near("largest overlap", a.max_overlap, b.max_overlap, 0.25);
    check_near("largest overlap share", a.max_overlap_share, b.max_overlap_share, 1.0);
    CHECK(a.max_speed == Approx(b.max_speed).epsilon(1e-5));
    CHECK(a.max_speed_share == Approx(b.max_speed_share).epsilon(1e-5));
    // Where the two largest eigenvalues agree, the closed form loses half of the digits.
    CHECK(a.max_stiffness == Approx(b.max_stiffness).epsilon(2e-3));
    CHECK(a.max_lightness == Approx(b.max_lightness).epsilon(1e-6));
    CHECK(a.max_damping == Approx(b.max_damping).epsilon(2e-3));
}

std::vector<Scene> scenes() {
    std::vector<Scene> all{scene_with("gravity,contact,restitution,walls", 300),
                           scene_with("contact,walls", 65),
                           scene_with("gravity,drag,restitution,walls", 200),
                           scene_with("gravity", 70),
                           scene_with("contact", 1),
                           scene_with("contact,walls", 0),
                           mixed_pile_scene(2500)};
    Scene moved = scene_with("gravity,drag,contact,restitution,walls,shake", 300);
    moved.settings.shake_amplitude = {0.05, 0.02, 0.05};
    moved.settings.pull = Pull{7, dvec3(0.5)};
    all.push_back(moved);
    Scene still_springs = scene_with("contact,walls,shake", 200);
    still_springs.settings.limit_force = false;
    all.push_back(still_springs);
    Scene own = scene_with("contact,restitution,walls,ball_restitution", 300);
    own.settings.limit_force = false;
    own.settings.neighbours = NeighbourSearch::brute_force;
    all.push_back(own);
    for (const Integrator integrator : {Integrator::velocity_verlet, Integrator::historical}) {
        Scene other = mixed_pile_scene(300);
        other.settings.laws.drag = true;
        other.settings.drag = 2.0;
        other.settings.integrator = integrator;
        all.push_back(other);
    }
    Scene pulled = scene_with("drag,walls", 3);
    pulled.settings.pull = Pull{1, dvec3(0.2)};
    all.push_back(pulled);
    return all;
}

Synchronisation synchronisation(const Simulation& simulation) {
    const Settings& s = simulation.settings();
    const double drag = s.laws.drag ? s.drag : 0.0;
    const double lag = simulation.velocity_lag();
    return synchronisation_of(substep_motion(s.integrator, drag, s.dt / s.substeps, lag), drag, lag,
                              simulation.schedule().in_place);
}

void agree_in(Simulation& simulation) {
    Backend& device = simulation.backend();
    cpu::CpuBackend<float> mirror;
    const Schedule& schedule = simulation.schedule();
    const SubstepParams<double> params = simulation.params();
    const BallState state = simulation.raw_state();
    mirror.load(state, schedule, simulation.settings().limit_force);
    for (Backend* backend : {&device, static_cast<Backend*>(&mirror)}) {
        if (!schedule.in_place) {
            backend->run(schedule, params, 0, schedule.dispatches.size());
        }
    }
    mirror.write(Slot::next_velocities, device.read(Slot::next_velocities));
    mirror.write(Slot::keys, device.read(Slot::keys));
    mirror.write(Slot::cell_ranges, device.read(Slot::cell_ranges));
    for (Backend* backend : {&device, static_cast<Backend*>(&mirror)}) {
        backend->request_reading(1, schedule, params, synchronisation(simulation));
    }
    check_agree(arrived(device, 1).front().reading, arrived(mirror, 1).front().reading,
                scale_of(state, params, schedule.features));
}

}  // namespace

void readings_agree_with_the_mirror(const MakeBackend& make) {
    for (const Scene& scene : scenes()) {
        INFO(scene.name << ", " << scene.settings.balls << " balls, "
                        << integrator_names[static_cast<std::size_t>(scene.settings.integrator)]);
        Simulation simulation(scene, scene.settings, 5, make());
        agree_in(simulation);
        for (int step = 0; step < 6; ++step) {
            simulation.step();
        }
        simulation.substep();
        agree_in(simulation);
    }
}

void readings_arrive_in_order(const MakeBackend& make) {
    const Scene scene = scene_with("gravity,contact,restitution,walls", 130);
    std::vector<MeterReading> first;
    for (int run = 0; run < 2; ++run) {
        Simulation simulation(scene, scene.settings, 5, make());
        simulation.set_metering(true);
        std::vector<MeterRecord> records;
        for (int step = 0; step < 40; ++step) {  // 320 substeps: more than the ring has entries
            simulation.step();
            if (step == 3) {
                for (const MeterRecord& record : simulation.take_records()) {
                    records.push_back(record);
                }
            }
        }
        for (int i = 0; i < 1000 && records.size() < 320; ++i) {
            simulation.backend().finish();
            for (const MeterRecord& record : simulation.take_records()) {
                records.push_back(record);
            }
        }
        REQUIRE(records.size() == 320);
        for (std::size_t i = 0; i < records.size(); ++i) {
            REQUIRE(records[i].step == i / 8);
            REQUIRE(records[i].substep == i % 8);
            REQUIRE(records[i].run == records.front().run);
            if (run == 0) {
                first.push_back(records[i].reading);
            } else {
                REQUIRE(records[i].reading.kinetic == first[i].kinetic);
                REQUIRE(records[i].reading.contact_heat == first[i].contact_heat);
            }
        }
    }
}

void metering_changes_nothing(const MakeBackend& make) {
    for (const char* laws : {"gravity,contact,restitution,walls", "gravity,drag,restitution,walls"}) {
        const Scene scene = scene_with(laws, 100);
        Simulation plain(scene, scene.settings, 5, make());
        Simulation metered(scene, scene.settings, 5, make());
        metered.set_metering(true);
        for (int step = 0; step < 20; ++step) {
            plain.step();
            metered.meter();
            metered.step();
        }
        CHECK(hash_state(plain.raw_state()) == hash_state(metered.raw_state()));
        CHECK(plain.backend().read(Slot::status) == metered.backend().read(Slot::status));
        CHECK(plain.take_records().empty());
    }
}

}  // namespace ballpit::test
