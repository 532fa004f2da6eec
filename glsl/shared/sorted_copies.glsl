// Copies of the state in the order of the sorted keys, so that balls that are near each other lie near each other in
// memory, where collide reads them.

layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_VELOCITIES) readonly buffer VelocitiesBlock { vec4 velocities[]; };
layout(std430, binding = BINDING_GATHERED_POSITIONS) writeonly buffer SortedPositionsBlock { vec4 sorted_positions[]; };
layout(std430, binding = BINDING_GATHERED_VELOCITIES) writeonly buffer SortedVelocitiesBlock {
    vec4 sorted_velocities[];
};

void copy_state(uint place, uint slot) {
    sorted_positions[slot] = positions[place];
    sorted_velocities[slot] = velocities[place];
}
