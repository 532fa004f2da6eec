#include "support/backend_contract.h"

#include <cmath>
#include <cstring>

#include "core/contact.h"
#include "support/catch.h"
#include "support/substep_setup.h"

namespace ballpit::test {

namespace {

BallState some_balls(std::uint32_t count) { return placed_balls(Placement::uniform, count); }

SubstepSetup some_setup(const BallState& state, SortMethod sort = SortMethod::bitonic_fused) {
    return setup_for(state, contact_features(), sort);
}

void run_substep(Backend& backend, const SubstepSetup& setup) {
    backend.run(setup.schedule, setup.params, 0, setup.schedule.dispatches.size());
    backend.swap_states();
}

std::uint64_t hash_of(Backend& backend) {
    return hash_state(read_slot<vec4>(backend, Slot::positions), read_slot<vec4>(backend, Slot::velocities));
}

// What poll() gives once it has something; the device may take its time.
std::optional<Bytes> arrived(Backend& backend, Slot slot) {
    backend.finish();
    for (int i = 0; i < 1000; ++i) {
        if (auto bytes = backend.poll(slot)) {
            return bytes;
        }
    }
    return std::nullopt;
}

std::vector<TaggedHash> arrived_hashes(Backend& backend, std::size_t count) {
    std::vector<TaggedHash> all;
    for (int i = 0; i < 1000 && all.size() < count; ++i) {
        backend.finish();
        for (const TaggedHash& hash : backend.take_hashes()) {
            all.push_back(hash);
        }
    }
    return all;
}

}  // namespace

void reads_what_was_loaded(Backend& backend) {
    for (const std::uint32_t count : {0u, 1u, 64u, 65u, 1000u}) {
        BallState state = some_balls(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            state.restitutions.push_back(static_cast<double>(random_between(0.1f, 1.0f, 10, i)));
        }
        const SubstepSetup setup = some_setup(state);
        for (const bool limit_force : {true, false}) {
            backend.load(state, setup.schedule, limit_force);
            CAPTURE(count, limit_force);
            CHECK((read_slot<vec4>(backend, Slot::positions) == state.positions));
            CHECK((read_slot<vec4>(backend, Slot::velocities) == state.velocities));
            const auto ratios = read_slot<float>(backend, Slot::damping_ratios);
            REQUIRE(ratios.size() == count);
            for (std::uint32_t i = 0; i < count; ++i) {
                const double e = state.restitutions[i];
                REQUIRE(ratios[i] == static_cast<float>(damping_ratio_from_restitution(e, limit_force)));
            }
            CHECK(backend.read(Slot::keys).size() == setup.schedule.key_count * sizeof(Key));
            CHECK(backend.read(Slot::cell_ranges).size() == setup.schedule.cell_count * sizeof(CellRange));
            CHECK(read_slot<Status>(backend, Slot::status).at(0).bits == 0);
        }
    }
    CHECK_FALSE(backend.name().empty());
    CHECK_FALSE(backend.device().empty());
    CHECK_FALSE(backend.driver().empty());
}

void reads_what_was_written(Backend& backend) {
    const BallState state = some_balls(100);
    backend.load(state, some_setup(state).schedule, true);
    auto velocities = state.velocities;
    velocities.resize(40);
    for (vec4& velocity : velocities) {
        velocity *= 2.0f;
    }
    write_slot(backend, Slot::velocities, velocities);  // the start of the slot; the rest stays
    const auto now = read_slot<vec4>(backend, Slot::velocities);
    CHECK(std::equal(velocities.begin(), velocities.end(), now.begin()));
    CHECK(std::equal(now.begin() + 40, now.end(), state.velocities.begin() + 40));
    const std::vector<Key> keys(128, Key{3, 4});
    write_slot(backend, Slot::keys, keys);
    CHECK((read_slot<Key>(backend, Slot::keys)[127] == Key{3, 4}));
    Status status{};
    status.over_capacity = 4;
    status.quarantined_ball = 8;
    write_slot(backend, Slot::status, std::vector{status});
    CHECK(read_slot<Status>(backend, Slot::status).at(0).over_capacity == 4);
    CHECK(read_slot<Status>(backend, Slot::status).at(0).quarantined_ball == 8);
}

void copies_arrive_as_of_the_request(Backend& backend) {
    const BallState state = some_balls(200);
    const SubstepSetup setup = some_setup(state);
    backend.load(state, setup.schedule, true);
    CHECK_FALSE(backend.poll(Slot::positions));  // nobody asked
    backend.request(Slot::positions);
    run_substep(backend, setup);
    backend.request(Slot::positions);  // one is under way: ignored
    const auto copy = arrived(backend, Slot::positions);
    REQUIRE(copy);
    CHECK((typed<vec4>(*copy) == state.positions));
    CHECK_FALSE(backend.poll(Slot::positions));  // once
    backend.request(Slot::positions);
    backend.request(Slot::keys);
    const auto keys = arrived(backend, Slot::keys);
    const auto positions = arrived(backend, Slot::positions);
    REQUIRE(keys);
    REQUIRE(positions);
    CHECK(*keys == backend.read(Slot::keys));
    CHECK(*positions == backend.read(Slot::positions));
}

void remembers_states(Backend& backend) {
    for (const std::uint32_t count : {0u, 65u}) {
        const BallState state = some_balls(count);
        const SubstepSetup setup = some_setup(state);
        backend.load(state, setup.schedule, true);
        backend.start_history(3);
        CHECK_FALSE(backend.poll_history());
        for (const std::size_t entries : {std::size_t{3}, std::size_t{2}}) {  // the first place is used again
            std::vector<vec4> expected;
            for (std::size_t i = 0; i < entries; ++i) {
                run_substep(backend, setup);
                backend.record_history();
                for (const Slot slot : {Slot::positions, Slot::velocities}) {
                    const auto now = read_slot<vec4>(backend, slot);
                    expected.insert(expected.end(), now.begin(), now.end());
                }
            }
            backend.request_history();
            run_substep(backend, setup);  // what comes later is not in it
            backend.finish();
            std::optional<Bytes> history;
            for (int i = 0; i < 1000 && !history; ++i) {
                history = backend.poll_history();
            }
            if (count == 0) {
                CHECK((!history || history->empty()));
                continue;
            }
            REQUIRE(history);
            CHECK((typed<vec4>(*history) == expected));
            CHECK_FALSE(backend.poll_history());
        }
        backend.start_history(0);
    }
}

void buffers_grow_and_shrink(Backend& backend) {
    for (const std::uint32_t count : {10u, 5000u, 0u, 65u, 20000u, 3u}) {
        const BallState state = some_balls(count);
        const SubstepSetup setup = some_setup(state);
        backend.load(state, setup.schedule, true);
        run_substep(backend, setup);
        CAPTURE(count);
        CHECK(read_slot<vec4>(backend, Slot::positions).size() == count);
        CHECK(read_slot<Key>(backend, Slot::keys).size() == setup.schedule.key_count);
    }
}

void reschedules_in_the_middle(Backend& backend) {
    const BallState state = some_balls(700);
    const SubstepSetup fused = some_setup(state);
    const SubstepSetup plain = some_setup(state, SortMethod::bitonic);
    Settings wide;
    wide.cell_factor = 2.0;
    const Grid grid = make_grid(dvec3(box_half_extent), static_cast<double>(usual_radius), 2.0, 700);
    const SubstepSetup coarse = setup_for(state, contact_features(), SortMethod::bitonic, wide, grid);
    backend.load(state, fused.schedule, true);
    run_substep(backend, fused);
    const std::uint64_t before = hash_of(backend);
    backend.reschedule(plain.schedule);
    CHECK(hash_of(backend) == before);
    CHECK(read_slot<CellRange>(backend, Slot::cell_ranges).size() == plain.schedule.cell_count);
    run_substep(backend, plain);
    backend.reschedule(coarse.schedule);
    CHECK(read_slot<CellRange>(backend, Slot::cell_ranges).size() == coarse.schedule.cell_count);
    run_substep(backend, coarse);
    CHECK(hash_of(backend) != before);
}

void times_every_stage(Backend& backend) {
    const BallState state = some_balls(3000);
    const SubstepSetup setup = some_setup(state);
    backend.load(state, setup.schedule, true);
    run_substep(backend, setup);
    backend.finish();
    CHECK(backend.take_times().empty());  // off until asked for
    backend.set_timing(true);
    for (int i = 0; i < 5; ++i) {
        run_substep(backend, setup);
    }
    std::vector<StageTimes> times;
    for (int i = 0; i < 1000 && times.size() < 5; ++i) {
        backend.finish();
        for (const StageTimes& one : backend.take_times()) {
            times.push_back(one);
        }
    }
    REQUIRE(times.size() == 5);
    for (const StageTimes& one : times) {
        for (const double ms : one) {
            CHECK(std::isfinite(ms));
            CHECK(ms >= 0.0);
        }
    }
    const auto sum_of = [&](Stage stage) {
        double sum = 0.0;
        for (const StageTimes& one : times) {
            sum += one[static_cast<std::size_t>(stage)];
        }
        return sum;
    };
    CHECK(sum_of(Stage::bitonic_sort) > 0.0);
    CHECK(sum_of(Stage::collide) > 0.0);
    backend.set_timing(false);
    run_substep(backend, setup);
    backend.finish();
    CHECK(backend.take_times().empty());
}

void status_adds_up(Backend& backend) {
    BallState state = some_balls(100);
    state.positions[3].x = 10.0f;
    const SubstepSetup setup = some_setup(state);
    backend.load(state, setup.schedule, true);
    for (std::uint32_t i = 1; i <= 3; ++i) {
        run_substep(backend, setup);
        const Status status = read_slot<Status>(backend, Slot::status).at(0);
        CHECK(status.bits == STATUS_OUT_OF_BOUNDS);
        CHECK(status.out_of_bounds == i);
    }
    backend.load(state, setup.schedule, true);
    CHECK(read_slot<Status>(backend, Slot::status).at(0).out_of_bounds == 0);
}

void saves_and_restores(Backend& backend) {
    BallState state = some_balls(300);
    state.restitutions.assign(300, 0.5);
    const SubstepSetup setup = some_setup(state);
    backend.load(state, setup.schedule, true);
    run_substep(backend, setup);  // so that the roles of the buffers are exchanged
    const auto saved = backend.save();
    CHECK(saved->ball_count() == 300);
    CHECK(saved->bytes() >= 600 * sizeof(vec4));
    const std::uint64_t at_save = hash_of(backend);
    run_substep(backend, setup);
    run_substep(backend, setup);
    const std::uint64_t ahead = hash_of(backend);
    CHECK(ahead != at_save);
    backend.restore(*saved, setup.schedule);
    CHECK(hash_of(backend) == at_save);
    run_substep(backend, setup);
    run_substep(backend, setup);
    CHECK(hash_of(backend) == ahead);
    // Also after another count was there.
    const BallState other = some_balls(5000);
    backend.load(other, some_setup(other).schedule, true);
    backend.restore(*saved, setup.schedule);
    CHECK(read_slot<vec4>(backend, Slot::positions).size() == 300);
    CHECK(read_slot<float>(backend, Slot::damping_ratios).size() == 300);
    run_substep(backend, setup);
    run_substep(backend, setup);
    CHECK(hash_of(backend) == ahead);
}

void hashes_the_state(Backend& backend) {
    for (const std::uint32_t count : {0u, 1u, 64u, 65u, 5000u}) {
        const BallState state = some_balls(count);
        const SubstepSetup setup = some_setup(state);
        backend.load(state, setup.schedule, true);
        std::vector<std::uint64_t> expected;
        for (std::uint64_t tag = 0; tag < 4; ++tag) {
            backend.request_hash(100 + tag);
            expected.push_back(hash_of(backend));
            run_substep(backend, setup);
        }
        const auto hashes = arrived_hashes(backend, 4);
        CAPTURE(count);
        REQUIRE(hashes.size() == 4);
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(hashes[i].tag == 100 + i);
            CHECK(hashes[i].hash == expected[i]);
        }
    }
}

void works_in_place(Backend& backend) {
    Features fall;
    fall.add(Feature::gravity);
    const BallState state = some_balls(300);
    const SubstepSetup setup = setup_for(state, fall, SortMethod::bitonic_fused);
    const SubstepSetup touching = some_setup(state);
    REQUIRE(setup.schedule.in_place);
    const auto substep = [&] { backend.run(setup.schedule, setup.params, 0, setup.schedule.dispatches.size()); };
    const auto has_one_state = [&] {
        return backend.read(Slot::next_positions).empty() && backend.read(Slot::next_velocities).empty() &&
               backend.read(Slot::keys).empty() && backend.read(Slot::cell_ranges).empty();
    };
    for (const bool after_contacts : {false, true}) {  // also where the roles of the state were exchanged before
        if (after_contacts) {
            backend.load(state, touching.schedule, true);
            run_substep(backend, touching);
        }
        backend.load(state, setup.schedule, true);
        CHECK(has_one_state());
        CHECK((read_slot<vec4>(backend, Slot::positions) == state.positions));
        substep();
        const auto saved = backend.save();
        const std::uint64_t at_save = hash_of(backend);
        CHECK(at_save != hash_state(state));
        substep();
        const std::uint64_t ahead = hash_of(backend);
        backend.restore(*saved, setup.schedule);
        CHECK(has_one_state());
        CHECK(hash_of(backend) == at_save);
        substep();
        CHECK(hash_of(backend) == ahead);
        // What was saved in place goes on with contacts, and the other way round.
        backend.restore(*saved, touching.schedule);
        CHECK(hash_of(backend) == at_save);
        CHECK(backend.read(Slot::next_positions).size() == 300 * sizeof(vec4));
        run_substep(backend, touching);
        const auto pushed = backend.save();
        const std::uint64_t with_contacts = hash_of(backend);
        backend.restore(*pushed, setup.schedule);
        CHECK(has_one_state());
        CHECK(hash_of(backend) == with_contacts);
        write_slot(backend, Slot::positions, state.positions);
        CHECK((read_slot<vec4>(backend, Slot::positions) == state.positions));
        backend.request(Slot::next_positions);
        backend.request(Slot::positions);
        CHECK(arrived(backend, Slot::positions)->size() == 300 * sizeof(vec4));
    }
}

}  // namespace ballpit::test
