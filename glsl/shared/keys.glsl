// The keys and their order: by cell id, ties by ball id.
layout(std430, binding = SLOT_KEYS) buffer KeysBlock { Key keys[]; };

bool key_less(Key a, Key b) {
    return a.cell_id != b.cell_id ? a.cell_id < b.cell_id : a.ball_id < b.ball_id;
}
