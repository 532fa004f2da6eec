// Which tiles of the cell table have been written to: only those are cleared and counted, so that an empty part of the
// box costs next to nothing. Who writes into the table marks the tile.
layout(std430, binding = BINDING_USED_TILES) buffer UsedTilesBlock { uint used_tiles[]; };

void mark_tile(uint cell) {
    if (used_tiles[cell / TILE_CELLS] == 0u) {   // many write there, all of them the same
        used_tiles[cell / TILE_CELLS] = 1u;
    }
}
