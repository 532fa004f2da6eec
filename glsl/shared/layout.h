// The facts that C++ and GLSL share: group sizes, buffer slots, sentinels and struct layouts.
// Both compilers read this very file (GLSL through the #include of our loader, C++ through core/layout.h),
// so there is no second copy to keep in step. Only facts live here, never logic.
// GLSL 4.30 wants literals for local_size_x and binding, hence macros instead of constants.
// In both languages a vec3 is followed by a 4-byte member, which makes std140, std430 and C++ agree;
// tests/layout_gpu_test.cpp asks the driver and compares.

#define GROUP_SIZE 64             // threads of a work group, one ball, slot or cell each
#define SORT_TILE_SIZE 4096       // keys a work group of the fused sort has in shared memory: 8 B each, 32 KiB in all
#define SORT_GROUP_SIZE 512       // its threads, eight keys each
#define SORT_SMALL_TILE_SIZE 2048 // the same where there are few keys: more groups, for all of a device to work
#define SORT_SMALL_GROUP_SIZE 256
#define SORT_SMALL_KEYS 65536     // few: up to so many
#define STRIDE_KEYS 8             // keys that three passes connect: a thread takes them through all three
#define TILE_GROUP_SIZE 256       // threads of a work group that goes through a tile of the cell table
#define TILE_CELLS 4096           // cells of a tile
#define FOLDED_WIDTH 32768        // groups of a row, where a dispatch has more than the 65535 that GL guarantees

#define SENTINEL 0xFFFFFFFFu      // cell id and ball id of the keys that pad to a power of two: they sort last

// Slots: the binding of each buffer, up to the tenth. GL 4.3 guarantees the first eight of them to a compute shader, and
// eight at a time; core/storage_limits.h refuses what a device has no room for.
#define SLOT_POSITIONS 0          // vec4 a ball: centre (m), radius (m)
#define SLOT_VELOCITIES 1         // vec4 a ball: velocity (m/s), mass (kg)
#define SLOT_DAMPING_RATIOS 2     // float a ball: dashpot zeta, only where a ball has a restitution of its own
#define SLOT_KEYS 3               // Key a slot, padded to the next power of two
#define SLOT_CELL_RANGES 4        // CellRange a cell
#define SLOT_STATUS 5             // one Status
#define SLOT_NEXT_POSITIONS 6     // as SLOT_POSITIONS, written by collide; where the order is kept, in that of the keys
#define SLOT_NEXT_VELOCITIES 7    // as SLOT_VELOCITIES, the same
#define SLOT_COMPENSATIONS 8      // Compensation a ball, only where sums are compensated
#define SLOT_BUILT_POSITIONS 9    // as SLOT_POSITIONS, when the grid was built; only where a grid is used more than once
#define SLOT_SORTED_POSITIONS 10  // as SLOT_POSITIONS, in the order of the sorted keys
#define SLOT_SORTED_VELOCITIES 11 // as SLOT_VELOCITIES, the same
#define SLOT_USED_TILES 12        // uint a tile of the cell table: 1 where one of its cells has been written to
#define SLOT_TICKETS 13           // uint a ball: how many balls have been counted into its cell before it
#define SLOT_SCATTERED_KEYS 14    // Key a slot: in the slots of its cell, in any order
#define SLOT_TILE_COUNTS 15       // uint a tile: balls in its cells
#define SLOT_ORIGINS 16           // uint a slot: where in the order of the substep before its ball was
#define SLOT_COUNT 17

// Slots from 10 on take the binding of a slot that the same shader does not use: core/schedule.h has them as
// binding_of(). Whoever reads the state finds it under SLOT_POSITIONS, wherever it is kept.
#define BINDING_GATHERED_POSITIONS SLOT_NEXT_POSITIONS
#define BINDING_GATHERED_VELOCITIES SLOT_NEXT_VELOCITIES
#define BINDING_USED_TILES SLOT_DAMPING_RATIOS
#define BINDING_TICKETS SLOT_NEXT_POSITIONS
#define BINDING_SCATTERED_KEYS SLOT_STATUS
#define BINDING_ORIGINS SLOT_DAMPING_RATIOS
#define BINDING_TILE_COUNTS SLOT_NEXT_POSITIONS

// hash_state is no part of a substep; its ring of results takes the place of a slot that it does not read.
#define BINDING_HASHES SLOT_KEYS  // HashSum an entry
#define HASH_RING_SIZE 256

// meter and meter_sum are no part of a substep either: their buffers take the places of slots that they do not read.
#define BINDING_METER_PARTS SLOT_STATUS          // METER_VALUES floats a work group
#define BINDING_METER_RING SLOT_NEXT_POSITIONS   // METER_VALUES floats an entry
#define METER_RING_SIZE 256
#define METER_LANES 32            // parts that meter_sum adds up side by side

// What is metered, by place. The first METER_SUMS are sums over all balls, the others the largest of any. Units and
// meaning: core/meter.h.
#define METER_KINETIC 0
#define METER_POTENTIAL 1
#define METER_ELASTIC 2
#define METER_CONTACT_HEAT 3
#define METER_WALL_HEAT 4
#define METER_WALL_WORK 5
#define METER_HAND_WORK 6
#define METER_MOMENTUM 7          // three
#define METER_ANGULAR_MOMENTUM 10 // three
#define METER_OVERLAP_SHARES 13
#define METER_CONTACT_ENDS 14
#define METER_WALL_CONTACTS 15
#define METER_FLOOR_FORCE 16
#define METER_MASS 17
#define METER_SUMS 18
#define METER_OVERLAP 18
#define METER_OVERLAP_SHARE 19
#define METER_SPEED 20
#define METER_STIFFNESS 21
#define METER_SPEED_SHARE 22
#define METER_LIGHTNESS 23
#define METER_DAMPING 24
#define METER_VALUES 25

// Uniform block of a shader: the constants of a substep that it needs, under the names of core/substep_params.h. Which
// those are differs from permutation to permutation, so the driver says where they lie.
#define BLOCK_PARAMS 0

// Bits of Status.bits, one for each kind of failure that a stage can meet.
#define STATUS_NOT_FINITE 1u      // collide: a ball's new position or velocity is no number, or too large to be squared
#define STATUS_OUT_OF_BOUNDS 2u   // assign_cells: a ball's centre lies outside the box
#define STATUS_OVER_CAPACITY 4u   // build_grid: a key names a cell or ball that has no room
#define STATUS_MISSED 8u          // count_missed: balls touched that the grid before did not show to each other
#define STATUS_TOO_FAST 16u       // collide: a ball moves by more than its radius
#define STATUS_COINCIDENT 32u     // collide: two balls have the same centre
#define STATUS_CAPPED_WALL 64u    // collide: a ball is deeper in a wall than the wall's push grows

struct Key {
    uint cell_id;
    uint ball_id;
};

// The slots [first, end) hold the balls of one cell; an empty cell has first == end == 0.
struct CellRange {
    uint first;
    uint end;
};

// What rounding has left out of a ball's position (m) and velocity (m/s): the full value is the sum of both. Six floats
// rather than two vec4: 24 bytes are read and written for every ball in every substep.
struct Compensation {
    float x;
    float y;
    float z;
    float vx;
    float vy;
    float vz;
};

// Two sums that make up the 64 bits of a state hash.
struct HashSum {
    uint low;
    uint high;
};

// What was seen, summed over substeps since the last reset; each kind's bit stays where its sum has run over.
struct Status {
    uint bits;
    uint not_finite;              // balls, each once: then it is in quarantine
    uint out_of_bounds;           // balls
    uint over_capacity;           // keys
    uint missed;                  // ends of such contacts: a pair that neither ball sees counts twice
    uint drift_bits;              // the largest square (m^2) of a ball's way from one build to the next, as a float's bits
    uint too_fast;                // balls
    uint coincident;              // pairs
    uint capped_walls;            // balls, once for each wall
    uint quarantined_ball;        // 1 + the highest id of a ball in quarantine; 0: none
};
