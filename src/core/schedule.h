// The step as data: a substep is a list of dispatches, built by a pure function. The GPU executor and the CPU
// backend walk the same list; stepping, timing, checking, labels and the stage strip read it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/features.h"
#include "core/grid.h"
#include "core/layout.h"
#include "core/settings.h"

namespace ballpit {

/// In the order of a substep with a bitonic sort. A counting sort comes after build_grid: it needs the cells' ranges.
enum class Stage : std::uint8_t { assign_cells, bitonic_sort, build_grid, counting_sort, collide };
inline constexpr std::array<std::string_view, 5> stage_names = {"assign_cells", "bitonic_sort", "build_grid",
                                                                "counting_sort", "collide"};
inline constexpr std::size_t stage_count = stage_names.size();
constexpr std::string_view stage_name(Stage stage) { return stage_names[static_cast<std::size_t>(stage)]; }

/// Shader files glsl/<name>.comp, each with a mirror src/cpu/<name>.cpp.
enum class Shader : std::uint8_t {
    assign_cells,
    bitonic_sort,
    bitonic_sort_fused,
    bitonic_sort_strides,
    clear_cells,
    build_grid,
    count_cells,
    count_tiles,
    scan_cells,
    scatter_keys,
    order_keys,
    count_missed,
    keep_places,
    gather,
    start_order,
    put_back,
    collide
};
inline constexpr std::array<std::string_view, 17> shader_names = {
    "assign_cells", "bitonic_sort", "bitonic_sort_fused", "bitonic_sort_strides",
    "clear_cells",  "build_grid",   "count_cells",        "count_tiles",
    "scan_cells",   "scatter_keys", "order_keys",         "count_missed",
    "keep_places",  "gather",       "start_order",        "put_back",
    "collide"};
constexpr std::string_view shader_name(Shader shader) { return shader_names[static_cast<std::size_t>(shader)]; }

/// The buffers, by the role they play in a substep.
enum class Slot : std::uint8_t {
    positions = SLOT_POSITIONS,
    velocities = SLOT_VELOCITIES,
    damping_ratios = SLOT_DAMPING_RATIOS,
    keys = SLOT_KEYS,
    cell_ranges = SLOT_CELL_RANGES,
    status = SLOT_STATUS,
    next_positions = SLOT_NEXT_POSITIONS,
    next_velocities = SLOT_NEXT_VELOCITIES,
    compensations = SLOT_COMPENSATIONS,
    built_positions = SLOT_BUILT_POSITIONS,
    sorted_positions = SLOT_SORTED_POSITIONS,
    sorted_velocities = SLOT_SORTED_VELOCITIES,
    used_tiles = SLOT_USED_TILES,
    tickets = SLOT_TICKETS,
    scattered_keys = SLOT_SCATTERED_KEYS,
    tile_counts = SLOT_TILE_COUNTS,
    origins = SLOT_ORIGINS,
};
inline constexpr std::size_t slot_count = SLOT_COUNT;
inline constexpr std::array<std::string_view, slot_count> slot_names = {
    "positions",     "velocities",      "damping_ratios",   "keys",
    "cell_ranges",   "status",          "next_positions",   "next_velocities",
    "compensations", "built_positions", "sorted_positions", "sorted_velocities",
    "used_tiles",    "tickets",         "scattered_keys",   "tile_counts",
    "origins"};
constexpr std::string_view slot_name(Slot slot) { return slot_names[static_cast<std::size_t>(slot)]; }

/// The number under which a shader finds a slot: its own, or that of a slot that the shader does not use.
std::uint32_t binding_of(Shader shader, Slot slot);

/// A program is a shader and the features it is compiled with.
struct Program {
    Shader shader{};
    Features features;
    friend constexpr bool operator==(Program, Program) = default;
    friend constexpr auto operator<=>(Program, Program) = default;
};

/// Work groups along x and y; y > 1 only beyond GL's guaranteed 65535 groups.
struct Groups {
    std::uint32_t x = 1;
    std::uint32_t y = 1;
    friend constexpr bool operator==(Groups, Groups) = default;
};

struct Dispatch {
    Stage stage{};
    std::string name;  // unique within the schedule: label, timer, panel row, test
    Program program;
    Groups groups;
    std::array<std::uint32_t, 4> constants{};  // uniform uvec4 dispatch_constants
    std::vector<Slot> reads;
    std::vector<Slot> writes;  // a slot may be in both
};

/// One substep, and what the buffers must hold for it.
struct Schedule {
    std::vector<Dispatch> dispatches;
    Features features;
    Grid grid;
    std::uint32_t ball_count = 0;
    std::uint32_t key_count = 0;  // 0 where no grid is needed
    std::uint32_t cell_count = 0;
    bool counts_cells = false;  // a counting sort
    bool in_place = false;      // no ball looks at another: one state buffer will do, nothing is written to next_*
    bool swaps_states = false;  // the next state is in next_*: positions and next_positions change roles at the end
    bool keeps_order = false;   // the state is in next_* at either end of a substep, in the order of its keys
    bool swaps_copies = false;  // and from there on plays the part of the sorted copies, because nothing sorts
    bool keeps_places = false;  // where balls were when the grid was built is kept, to tell what a used grid misses
};

inline constexpr std::uint32_t widest_dispatch = 65535;  // GL_MAX_COMPUTE_WORK_GROUP_COUNT is at least this

/// Groups that cover this many invocations of groups of `group_size`.
Groups groups_for(std::uint32_t invocations, std::uint32_t group_size);

/// Keys of a tile of the fused sort, where there are so many in all.
std::uint32_t sort_tile_size(std::uint32_t key_count);

/// Tiles of the cell table, the last one perhaps not whole.
std::uint32_t tile_count(std::uint32_t cell_count);

/// The dispatches of a substep. `sort`: not `automatic`. No balls: an empty list. No contact law, or brute force: a
/// single `collide`, no grid. Without the contact law it works in place. `grid_reuse`: how many substeps use one grid;
/// from two on a build also counts what the grid before did not show, with diagnostics.
Schedule make_schedule(std::uint32_t ball_count, const Grid& grid, Features features, SortMethod sort,
                       std::uint32_t grid_reuse = 1);

/// The substep that uses the grid of an earlier one: `schedule` without what builds it. Without a grid: the same. One
/// that keeps the order can only follow one that does, too.
Schedule with_grid_reused(Schedule schedule);

/// Whether the features ask for it, and there is a counting sort, which alone can tell where a ball was before.
bool can_keep_order(const Schedule& schedule);

/// The same substep for balls that stay in the order of their keys from substep to substep: memory is then read and
/// written nearly in rows, as balls seldom change their cells, and there are fewer dispatches. Nobody but the next such
/// substep can use what it leaves behind. Between the two worlds: start_order before the first one, put_back for
/// whoever wants to see `positions` and `velocities`. schedule: builds its grid; can_keep_order().
Schedule keeping_order(const Schedule& schedule);
Dispatch start_order(std::uint32_t ball_count);
Dispatch put_back(std::uint32_t ball_count);

/// start_order, one substep that keeps the order, put_back: for whoever checks dispatch by dispatch.
Schedule there_and_back(const Schedule& schedule);

}  // namespace ballpit
