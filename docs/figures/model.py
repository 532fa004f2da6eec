"""The algorithm once more, small and in plain Python: what the figures show is computed here, not drawn by hand.
The example is flat (one layer of cells), the words are those of the code."""

from math import atan2, exp, expm1, floor, log, pi, sqrt

SENTINEL = 0xFFFFFFFF
GROUP_SIZE = 64
SORT_TILE_SIZE = 2048      # of up to 65536 keys
CELLS = (5, 4)          # along x and y, each 1 m wide

# x (m), y (m), radius (m): the largest diameter is the cell width.
BALLS = [(0.62, 0.55, 0.40), (3.35, 2.60, 0.50), (1.45, 0.70, 0.50), (2.62, 1.42, 0.42), (4.45, 0.60, 0.45),
         (1.82, 1.55, 0.45), (2.30, 2.10, 0.40), (3.80, 2.15, 0.30), (0.55, 3.30, 0.38), (4.30, 3.40, 0.42),
         (0.75, 2.30, 0.35)]


def cell_of(ball):
    return tuple(min(max(floor(ball[axis]), 0), CELLS[axis] - 1) for axis in range(2))


def cell_id(cell):
    return cell[1] * CELLS[0] + cell[0]


def key_count(ball_count):
    return 1 << (ball_count - 1).bit_length() if ball_count else 0


def assign_cells(balls):
    keys = [(cell_id(cell_of(ball)), i) for i, ball in enumerate(balls)]
    return keys + [(SENTINEL, SENTINEL)] * (key_count(len(balls)) - len(balls))


def passes(count):
    """The passes (k, j) of the bitonic network, in running order."""
    k = 2
    while k <= count:
        j = k // 2
        while j > 0:
            yield k, j
            j //= 2
        k *= 2


def bitonic_sort(keys, k, j):
    """One pass in place; gives (lower, upper, ascending, exchanged) of every pair."""
    pairs = []
    for pair in range(len(keys) // 2):
        lower = ((pair & ~(j - 1)) << 1) | (pair & (j - 1))
        upper = lower | j
        ascending = (lower & k) == 0
        differ = keys[upper] != keys[lower]
        if (keys[upper] < keys[lower]) == ascending:
            keys[lower], keys[upper] = keys[upper], keys[lower]
            pairs.append((lower, upper, ascending, differ))     # two sentinels change places unseen
        else:
            pairs.append((lower, upper, ascending, False))
    return pairs


def sort_dispatches(count, fused):
    """Dispatches of the sort, each the list of the passes that it does."""
    everything = list(passes(count))
    if not fused:
        return [[p] for p in everything]
    tile = min(SORT_TILE_SIZE, count)
    dispatches = []
    for k, j in everything:
        inside = j < tile
        starts = j == tile // 2 and k > tile
        if inside and dispatches and dispatches[-1][-1][1] < tile and not starts:
            dispatches[-1].append((k, j))
        else:
            dispatches.append([(k, j)])
    return dispatches


def by_threes(dispatches):
    """Up to three passes of one k that reach beyond a tile become one dispatch."""
    grouped = []
    for done in dispatches:
        beyond = done[0][1] >= SORT_TILE_SIZE
        if (beyond and grouped and grouped[-1][0][0] == done[0][0] and grouped[-1][-1][1] >= SORT_TILE_SIZE
                and len(grouped[-1]) < 3):
            grouped[-1] = grouped[-1] + done
        else:
            grouped.append(done)
    return grouped


def build_grid(keys, ball_count, ranges):
    for slot in range(ball_count):
        cell = keys[slot][0]
        if slot == 0 or keys[slot - 1][0] != cell:
            ranges[cell] = (slot, ranges[cell][1])
        if slot + 1 == ball_count or keys[slot + 1][0] != cell:
            ranges[cell] = (ranges[cell][0], slot + 1)
    return ranges


def neighbours(ball, keys, ranges):
    """(cell, slot, other ball) in the order in which collide meets them."""
    x, y = cell_of(BALLS[ball])
    for cy in range(max(y - 1, 0), min(y + 1, CELLS[1] - 1) + 1):
        for cx in range(max(x - 1, 0), min(x + 1, CELLS[0] - 1) + 1):
            cell = cell_id((cx, cy))
            for slot in range(*ranges[cell]):
                yield cell, slot, keys[slot][1]


def overlap(a, b):
    return a[2] + b[2] - sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2)


def schedule(ball_count):
    """(name, groups, reads, writes) of a substep with contacts and the fused sort."""
    keys = key_count(ball_count)

    def groups(invocations):
        return -(-invocations // GROUP_SIZE)
    rows = [("assign_cells", groups(keys), ["positions", "status"], ["keys", "status"])]
    for done in by_threes(sort_dispatches(keys, fused=True)):
        (k, j), (k_last, j_last) = done[0], done[-1]
        if j >= SORT_TILE_SIZE and len(done) > 1:
            rows.append((f"bitonic_sort_strides k={k} j={j}..{j_last}", groups(keys // 8), ["keys"], ["keys"]))
        elif j >= SORT_TILE_SIZE:
            rows.append((f"bitonic_sort k={k} j={j}", groups(keys // 2), ["keys"], ["keys"]))
        else:
            what = f"k={k} j={j}..1" if k == k_last else f"k={k}..{k_last}"
            rows.append((f"bitonic_sort_fused {what}", max(1, keys // SORT_TILE_SIZE), ["keys"], ["keys"]))
    rows.append(("clear_cells", None, ["used_tiles"], ["cell_ranges", "used_tiles"]))
    rows.append(("build_grid", groups(ball_count), ["keys", "used_tiles", "status"],
                 ["cell_ranges", "used_tiles", "status"]))
    rows.append(("gather", groups(ball_count), ["positions", "velocities", "keys"],
                 ["sorted_positions", "sorted_velocities"]))
    rows.append(("collide", groups(ball_count),
                 ["sorted_positions", "sorted_velocities", "status", "keys", "cell_ranges"],
                 ["next_positions", "next_velocities", "status"]))
    return rows


def barriers(rows):
    """Before which rows a barrier is due: a slot was written and is used, or was read and is written."""
    written, read, due = set(), set(), []
    for _, _, reads, writes in rows:
        due.append(bool(written & set(reads + writes)) or bool(read & set(writes)))
        if due[-1]:
            written, read = set(), set()
        read |= set(reads)
        written |= set(writes)
    return due


def make_kick(drag, duration):
    exponent = -drag * duration
    return exp(exponent), duration if exponent == 0 else expm1(exponent) / -drag


def substeps(integrator, acceleration, x, v, dt, count, drag=0.0):
    """(x, v) after each substep, v synchronised to the time of x."""
    lag = 0.0
    states = [(x, v)]
    for _ in range(count):
        a = acceleration(x)
        if integrator == "leapfrog":
            decay, gain = make_kick(drag, lag + dt / 2)
            v = decay * v + gain * a
            x, lag = x + dt * v, dt / 2
        elif integrator == "velocity_verlet":
            for duration in (lag, dt / 2):
                decay, gain = make_kick(drag, duration)
                v = decay * v + gain * a
            x, lag = x + dt * v, dt / 2
        else:
            decay, gain = make_kick(drag, dt)
            kicked = decay * v + gain * a
            moved = {"symplectic_euler": x + dt * kicked, "forward_euler": x + dt * v,
                     "historical": x + (dt * v + 0.5 * dt * dt * a)}[integrator]
            x, v = moved, kicked
        decay, gain = make_kick(drag, lag)
        states.append((x, decay * v + gain * acceleration(x)))
    return states


def restitution(zeta, limit_force):
    if not limit_force:
        return exp(-pi * zeta / sqrt(1 - zeta * zeta)) if zeta < 1 else 0.0
    if zeta < 1:
        s = sqrt(1 - zeta * zeta)
        return exp(-(zeta / s) * (pi - atan2(2 * zeta * s, 1 - 2 * zeta * zeta)))
    s = sqrt(zeta * zeta - 1)
    return exp(-(zeta / s) * log((zeta + s) / (zeta - s))) if s else exp(-2)


def damping_ratio(e, limit_force):
    low, high = 0.0, 4.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if restitution(middle, limit_force) > e else (low, middle)
    return low
