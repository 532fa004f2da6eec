// The step as data: whatever the count, the laws and the sort, the list of dispatches makes sense by itself.
#include "core/schedule.h"

#include <algorithm>
#include <bit>
#include <set>
#include <utility>

#include "cpu/bitonic_sort.h"
#include "support/catch.h"

using namespace ballpit;

namespace {

using Pass = std::pair<std::uint32_t, std::uint32_t>;  // k, j

constexpr std::array sorts = {SortMethod::bitonic, SortMethod::bitonic_fused, SortMethod::counting};

Schedule schedule_of(std::uint32_t balls, SortMethod sort, bool contact = true) {
    Features features;
    features.add(Feature::gravity);
    features.add(Feature::contact, contact);
    return make_schedule(balls, make_grid(dvec3(2.0), 0.1, 1.0, balls), features, sort);
}

std::vector<std::uint32_t> counts() {
    std::vector<std::uint32_t> all;
    for (std::uint32_t n = 0; n <= 2 * GROUP_SIZE; ++n) {
        all.push_back(n);
    }
    for (std::uint32_t power = 256; power <= maximum_balls; power *= 2) {
        all.insert(all.end(), {power - 1, power, std::min(power + 1, maximum_balls)});
    }
    all.insert(all.end(), {5000, 65537, 1000000});
    return all;
}

std::uint64_t total(const Groups& groups) { return static_cast<std::uint64_t>(groups.x) * groups.y; }

// The compare-exchange sweeps that the sort's dispatches stand for, in order.
std::vector<Pass> passes_of(const Schedule& schedule) {
    std::vector<Pass> passes;
    for (const Dispatch& dispatch : schedule.dispatches) {
        if (dispatch.program.shader == Shader::bitonic_sort) {
            passes.emplace_back(dispatch.constants[0], dispatch.constants[1]);
        } else if (dispatch.program.shader == Shader::bitonic_sort_strides) {
            for (std::uint32_t pass = 0; pass < dispatch.constants[2]; ++pass) {
                passes.emplace_back(dispatch.constants[0], dispatch.constants[1] >> pass);
            }
            // The eight slots of a thread are there.
            CHECK(STRIDE_KEYS * (dispatch.constants[1] >> (dispatch.constants[2] - 1)) <= schedule.key_count);
        } else if (dispatch.program.shader == Shader::bitonic_sort_fused) {
            std::uint32_t j = dispatch.constants[2];
            for (std::uint32_t k = dispatch.constants[0]; k <= dispatch.constants[1]; k *= 2) {
                for (; j > 0; j /= 2) {
                    CHECK(j < dispatch.constants[3]);  // partners must lie in one tile
                    passes.emplace_back(k, j);
                }
                j = k;
            }
        }
    }
    return passes;
}

std::vector<Pass> bitonic_network(std::uint32_t keys) {
    std::vector<Pass> passes;
    for (std::uint64_t k = 2; k <= keys; k *= 2) {
        for (std::uint64_t j = k / 2; j > 0; j /= 2) {
            passes.emplace_back(k, j);
        }
    }
    return passes;
}

}  // namespace

TEST_CASE("no balls, no dispatches", "[core]") {
    for (const SortMethod sort : sorts) {
        CHECK(schedule_of(0, sort).dispatches.empty());
        CHECK(schedule_of(0, sort).key_count == 0);
    }
}

TEST_CASE("without a contact law there is one collide and no grid", "[core]") {
    const Schedule schedule = schedule_of(5000, SortMethod::bitonic, false);
    REQUIRE(schedule.dispatches.size() == 1);
    CHECK(schedule.dispatches[0].stage == Stage::collide);
    CHECK(schedule.key_count == 0);
    CHECK(schedule.cell_count == 0);
    CHECK(std::ranges::count(schedule.dispatches[0].reads, Slot::keys) == 0);
}

TEST_CASE("dispatches have unique names and stages in order", "[core]") {
    for (const std::uint32_t balls : counts()) {
        for (const SortMethod sort : sorts) {
            const Schedule schedule = schedule_of(balls, sort);
            std::set<std::string> names;
            for (const Dispatch& dispatch : schedule.dispatches) {
                CHECK(names.insert(dispatch.name).second);
            }
            CHECK(std::ranges::is_sorted(schedule.dispatches, {}, &Dispatch::stage));
        }
    }
}

TEST_CASE("every slot is written before it is read", "[core]") {
    for (const std::uint32_t balls : counts()) {
        for (const SortMethod sort : sorts) {
            // What load() leaves: the state, the status, no tile marked. Keys, ranges and the next state come from the
            // substep.
            std::set<Slot> known = {Slot::positions, Slot::velocities, Slot::damping_ratios, Slot::status,
                                    Slot::used_tiles};
            const Schedule schedule = schedule_of(balls, sort);
            for (const Dispatch& dispatch : schedule.dispatches) {
                CAPTURE(balls, dispatch.name);
                CHECK(std::ranges::all_of(dispatch.reads, [&](Slot slot) { return known.contains(slot); }));
                known.insert(dispatch.writes.begin(), dispatch.writes.end());
            }
            CHECK((balls == 0 || (known.contains(Slot::next_positions) && known.contains(Slot::next_velocities))));
        }
    }
}

TEST_CASE("collide never writes what it reads of the balls", "[core]") {
    // The trap: writing in place while other threads still read.
    const Schedule schedule = schedule_of(100, SortMethod::bitonic_fused);
    const Dispatch& collide = schedule.dispatches.back();
    for (const Slot slot : {Slot::positions, Slot::velocities}) {
        CHECK(std::ranges::count(collide.reads, slot) == 1);
        CHECK(std::ranges::count(collide.writes, slot) == 0);
    }
}

TEST_CASE("the cell table is cleared before it is built", "[core]") {
    for (const std::uint32_t balls : {1u, 2u, 5000u}) {
        const auto dispatches = schedule_of(balls, SortMethod::bitonic).dispatches;
        const auto cleared = std::ranges::find(dispatches, std::string("clear_cells"), &Dispatch::name);
        const auto built = std::ranges::find(dispatches, std::string("build_grid"), &Dispatch::name);
        REQUIRE(cleared != dispatches.end());
        REQUIRE(built != dispatches.end());
        CHECK(cleared < built);
    }
}

TEST_CASE("work groups cover what they must, within GL's limits", "[core]") {
    for (const std::uint32_t invocations :
         {0u, 1u, 63u, 64u, 65u, 65535u * 64u, 65535u * 64u + 1u, 1u << 24, 1u << 28}) {
        const Groups groups = groups_for(invocations, 64);
        CAPTURE(invocations, groups.x, groups.y);
        CHECK(groups.x <= 65535);
        CHECK(groups.y <= 65535);
        CHECK(total(groups) * 64 >= invocations);
        CHECK(total(groups) * 64 < static_cast<std::uint64_t>(invocations) + 64ull * 65536ull);
    }
    CHECK(groups_for(65, 64) == Groups{2, 1});
}

TEST_CASE("every dispatch has a thread for each ball, pair, slot and cell", "[core]") {
    for (const std::uint32_t balls : counts()) {
        for (const SortMethod sort : sorts) {
            const Schedule schedule = schedule_of(balls, sort);
            for (const Dispatch& dispatch : schedule.dispatches) {
                CAPTURE(balls, dispatch.name);
                const std::uint64_t groups = total(dispatch.groups);
                switch (dispatch.program.shader) {
                    case Shader::assign_cells:
                        CHECK(groups * GROUP_SIZE >= schedule.key_count);
                        break;
                    case Shader::bitonic_sort:
                        CHECK(groups * GROUP_SIZE >= schedule.key_count / 2);
                        break;
                    case Shader::bitonic_sort_fused:
                        CHECK(groups * dispatch.constants[3] >= schedule.key_count);
                        break;
                    case Shader::bitonic_sort_strides:
                        CHECK(groups * GROUP_SIZE * STRIDE_KEYS >= schedule.key_count);
                        break;
                    case Shader::clear_cells:
                    case Shader::count_tiles:
                    case Shader::scan_cells:
                        CHECK(groups * TILE_CELLS >= schedule.cell_count);
                        break;
                    case Shader::build_grid:
                    case Shader::count_cells:
                    case Shader::scatter_keys:
                    case Shader::order_keys:
                    case Shader::count_missed:
                    case Shader::keep_places:
                    case Shader::gather:
                    case Shader::start_order:
                    case Shader::put_back:
                    case Shader::collide:
                        CHECK(groups * GROUP_SIZE >= balls);
                        break;
                }
            }
        }
    }
}

TEST_CASE("the keys are padded to the next power of two", "[core]") {
    for (const std::uint32_t balls : counts()) {
        const Schedule schedule = schedule_of(balls, SortMethod::bitonic);
        CAPTURE(balls);
        CHECK(schedule.key_count == (balls == 0 ? 0 : std::bit_ceil(balls)));
    }
}

TEST_CASE("both sorts are the same network, the fused one in fewer dispatches", "[core]") {
    for (std::uint32_t keys = 1; keys <= maximum_balls; keys *= 2) {
        const Schedule plain = schedule_of(keys, SortMethod::bitonic);
        const Schedule fused = schedule_of(keys, SortMethod::bitonic_fused);
        CAPTURE(keys);
        CHECK((passes_of(plain) == bitonic_network(keys)));
        CHECK((passes_of(fused) == bitonic_network(keys)));
        CHECK(fused.dispatches.size() <= plain.dispatches.size());
    }
    // The trap: all passes seeing the parameters of the last one. Each dispatch carries its own.
    const auto passes = passes_of(schedule_of(5000, SortMethod::bitonic));
    CHECK(std::set<Pass>(passes.begin(), passes.end()).size() == passes.size());
}

TEST_CASE("the network sorts: every sequence of zeros and ones (0-1 principle)", "[core]") {
    for (const std::uint32_t keys : {1u, 2u, 4u, 8u, 16u}) {
        const auto passes = bitonic_network(keys);
        for (std::uint32_t pattern = 0; pattern < (1u << keys); ++pattern) {
            std::vector<Key> sequence(keys);
            for (std::uint32_t i = 0; i < keys; ++i) {
                sequence[i] = {pattern >> i & 1u, 0};
            }
            for (const auto& [k, j] : passes) {
                cpu::bitonic_sort(sequence, k, j);
            }
            REQUIRE(std::ranges::is_sorted(sequence, {}, &Key::cell_id));
            REQUIRE(std::ranges::count(sequence, 1u, &Key::cell_id) == std::popcount(pattern));
        }
    }
}

TEST_CASE("only collide has permutations by laws, so a law does not compile the other shaders again", "[core]") {
    for (const Dispatch& dispatch : schedule_of(5000, SortMethod::bitonic_fused).dispatches) {
        CAPTURE(dispatch.name);
        const Features laws = dispatch.program.features.without(Feature::small_tiles);
        CHECK((laws.bits != 0) == (dispatch.program.shader == Shader::collide));
    }
}
