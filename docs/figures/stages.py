"""One picture per dispatch of a substep, from one example: eleven balls in a flat box of 5 x 4 cells."""

import model
from svg import AMBER, BLUE, GREEN, GREY, INK, LINE, ORANGE, SHADE, SKY, Picture, tint

SCALE = 84


def sorted_keys():
    keys = model.assign_cells(model.BALLS)
    for k, j in model.passes(len(keys)):
        model.bitonic_sort(keys, k, j)
    assert keys == sorted(keys)
    return keys


def empty_ranges():
    return [(0, 0)] * (model.CELLS[0] * model.CELLS[1])


def cell_text(key):
    return "S" if key[0] == model.SENTINEL else str(key[0])


def ball_text(key):
    return "S" if key[1] == model.SENTINEL else str(key[1])


class Box:
    """The example's box, seen from above, y up."""

    def __init__(self, picture, left, top):
        self.picture, self.left, self.top = picture, left, top

    def place(self, x, y):
        return self.left + SCALE * x, self.top + SCALE * (model.CELLS[1] - y)

    def cells(self, shaded=()):
        for y in range(model.CELLS[1]):
            for x in range(model.CELLS[0]):
                px, py = self.place(x, y + 1)
                cell = model.cell_id((x, y))
                self.picture.rect(px, py, SCALE, SCALE, SHADE if cell in shaded else "#ffffff", LINE, 1)
        self.picture.rect(self.left, self.top, SCALE * model.CELLS[0], SCALE * model.CELLS[1], width=2.5)

    def balls(self, colours):
        for i, (x, y, r) in enumerate(model.BALLS):
            px, py = self.place(x, y)
            fill, stroke, width = colours(i)
            self.picture.circle(px, py, SCALE * r, fill, stroke, width)
        for cell in range(model.CELLS[0] * model.CELLS[1]):
            px, py = self.place(cell % model.CELLS[0], cell // model.CELLS[0] + 1)
            self.picture.text(px + 5, py + 18, str(cell), 15, BLUE)
        for i, (x, y, _) in enumerate(model.BALLS):
            px, py = self.place(x, y)
            self.picture.circle(px, py, 3, INK, "none", 0)
            self.picture.text(px + 6, py - 5, str(i), 18, bold=True)


def key_row(p, left, top, keys, width=40, labels=True):
    for i, key in enumerate(keys):
        sentinel = key[0] == model.SENTINEL
        x = left + i * width
        p.rect(x, top, width, 54, SHADE if sentinel else "#ffffff", INK, 1.2)
        p.text(x + width / 2, top + 23, cell_text(key), 17, BLUE, "middle", bold=True)
        p.text(x + width / 2, top + 46, ball_text(key), 16, GREY if sentinel else INK, "middle")
    if labels:
        p.text(left - 10, top + 23, "cell id", 15, BLUE, "end", bold=True)
        p.text(left - 10, top + 46, "ball id", 15, INK, "end")


def slot_numbers(p, left, top, count, width=40, word="slot"):
    for i in range(count):
        p.text(left + (i + 0.5) * width, top, str(i), 13, GREY, "middle")
    p.text(left - 10, top, word, 13, GREY, "end")


def assign_cells():
    p = Picture(960, 560, "assign_cells: every ball gets the id of the cell that its centre lies in")
    box = Box(p, 40, 40)
    box.cells()
    box.balls(lambda i: (tint(SKY, 0.33), BLUE, 2))
    p.text(500, 62, "cell id = (z · cells.y + y) · cells.x + x", 19, bold=True)
    p.text(500, 94, "The centre decides: ball 1 reaches into four cells", 17)
    p.text(500, 118, "and belongs to cell 13.", 17)
    p.text(500, 160, "One thread a key. Thread i writes key i and", 17)
    p.text(500, 184, "nothing else: no race.", 17)
    keys = model.assign_cells(model.BALLS)
    assert keys[1][0] == 13
    p.text(500, 236, f"{len(model.BALLS)} balls, {len(keys)} keys: the next power of two.", 17)
    p.text(500, 260, "S is the sentinel 0xFFFFFFFF: it sorts last.", 17)
    key_row(p, 130, 452, keys, 48)
    slot_numbers(p, 130, 440, len(keys), 48, "key")
    p.text(130, 540, "keys[] after assign_cells", 16, bold=True)
    return p.finish()


def bitonic_sort():
    keys = model.assign_cells(model.BALLS)
    count, gap, left, top, step = len(keys), 32, 92, 112, 21
    x = left
    plan, columns = [], [(x, list(keys))]
    for k, j in model.passes(count):
        first = x + 26
        pairs = model.bitonic_sort(keys, k, j)
        plan.append((k, j, first, pairs))
        x = first + (j - 1) * step
        if j == 1:
            columns.append((x + 16, list(keys)))
            x += 16 + 34
    p = Picture(960, 700, "bitonic_sort: the ten passes that sort sixteen keys")
    p.text(40, 36, "Each arrow is one thread: it compares two slots and points to where the larger key goes.", 18)
    for slot in range(count):
        y = top + slot * gap
        p.line(left, y, x - 20, y, LINE, 1)
        p.text(left - 44, y + 5, f"slot {slot}", 13, GREY, "end")
    for k, j, first, pairs in plan:
        p.text(first + (j - 1) * step / 2, top - 22, f"j={j}", 14, anchor="middle")
        for lower, upper, ascending, exchanged in pairs:
            px = first + (lower % (2 * j) % j) * step if j > 1 else first
            a, b = top + lower * gap, top + upper * gap
            colour = BLUE if ascending else ORANGE
            start, end = (a, b) if ascending else (b, a)
            p.arrow(px, start, px, end, colour, 3.2 if exchanged else 1.2, None if exchanged else "4 3", 9)
    for index, (cx, values) in enumerate(columns):
        for slot, key in enumerate(values):
            y = top + slot * gap
            p.rect(cx - 34 if index == 0 else cx - 3, y - 12, 32, 24, "#ffffff", "none", 0)
            p.text(cx - 18 if index == 0 else cx + 13, y + 6, cell_text(key), 16, INK, "middle", bold=index in (0, 4))
    for k in (2, 4, 8, 16):
        block = [(first, j) for kk, j, first, _ in plan if kk == k]
        middle = (block[0][0] + block[-1][0]) / 2
        p.text(middle, top - 46, f"k={k}", 18, anchor="middle", bold=True)
    assert keys == sorted(keys)
    y = top + count * gap + 14
    p.arrow(92, y - 14, 92, y + 14, BLUE, 2)
    p.text(106, y + 6, "ascending (slot AND k is 0)", 16)
    p.arrow(340, y + 14, 340, y - 14, ORANGE, 2)
    p.text(354, y + 6, "descending", 16)
    p.line(470, y, 500, y, INK, 3.2)
    p.text(508, y + 6, "exchanges", 16)
    p.line(610, y, 640, y, INK, 1.2, "4 3")
    p.text(648, y + 6, "compares, already in order", 16)
    p.text(92, y + 46, "Numbers on the wires are cell ids before the sort and after each k; S is the sentinel. Ties go by ball id.",
           15, GREY)
    return p.finish()


def bitonic_sort_fused():
    count = model.key_count(5000)
    fused, plain = model.sort_dispatches(count, True), model.sort_dispatches(count, False)
    p = Picture(960, 700, "bitonic_sort_fused: which passes share a dispatch")
    p.text(40, 38, f"5000 balls, {count} keys: every square is one of {len(plain)} passes.", 18, bold=True)
    p.text(40, 64, f"Pass by pass that is {len(plain)} dispatches; fused it is {len(fused)}.", 18)
    left, top, w, h = 110, 118, 56, 36
    logs = count.bit_length() - 1
    for b in range(logs):
        p.text(left + (b + 0.5) * w, top - 10, str(count >> (b + 1)), 13, GREY, "middle")
        p.text(left - 10, top + (b + 0.65) * h, f"k={2 << b}", 15, anchor="end")
    p.text(left - 10, top - 10, "j =", 13, GREY, "end")
    for number, passes in enumerate(fused):
        inside = passes[0][1] < model.SORT_TILE_SIZE
        for k, j in passes:
            column, row = logs - 1 - (j.bit_length() - 1), k.bit_length() - 2
            p.rect(left + column * w + 2, top + row * h + 2, w - 4, h - 4, tint(SKY, 0.40) if inside else tint(AMBER, 0.60),
                   BLUE if inside else ORANGE, 1.2, 4)
            p.text(left + (column + 0.5) * w, top + (row + 0.68) * h, str(number + 1), 17, anchor="middle", bold=True)
    y = top + logs * h + 28
    p.rect(110, y, 26, 20, tint(SKY, 0.40), BLUE, 1.2, 4)
    p.text(146, y + 16, f"fused: pairs stay inside a tile of {model.SORT_TILE_SIZE} slots, in shared memory", 16)
    p.rect(640, y, 26, 20, tint(AMBER, 0.60), ORANGE, 1.2, 4)
    p.text(676, y + 16, "a dispatch of its own", 16)
    p.text(110, y + 48, "The number in a square is the dispatch that does it.", 15, GREY)
    return p.finish()


def moved_ranges():
    """Cell ranges of the example, and the same after ball 4 went from cell 4 to cell 9."""
    before = model.build_grid(sorted_keys(), len(model.BALLS), empty_ranges())
    keys = sorted((9 if ball == 4 else cell, ball) for cell, ball in sorted_keys())
    return before, keys


def range_row(p, left, top, ranges, cells, highlight, width):
    for cell in cells:
        first, end = ranges[cell]
        empty = (first, end) == (0, 0)
        x = left + cell * width
        fill, stroke, line = highlight.get(cell, ("#ffffff", INK, 1.2))
        p.rect(x, top, width, 34, fill, stroke, line)
        p.text(x + width / 2, top + 23, "–" if empty else f"{first},{end}", 15, GREY if empty else INK, "middle")


def clear_cells():
    before, keys = moved_ranges()
    stale = model.build_grid(keys, len(model.BALLS), list(before))
    fresh = model.build_grid(keys, len(model.BALLS), empty_ranges())
    wrong = [cell for cell in range(len(fresh)) if stale[cell] != fresh[cell]]
    assert wrong == [4]
    p = Picture(960, 430, "clear_cells: what a table that is not cleared would say")
    p.text(40, 38, "Ball 4 has moved from cell 4 to cell 9. No slot belongs to cell 4 now, so nobody writes it.", 18)
    width, cells = 74, range(10)
    left = 190
    for cell in cells:
        p.text(left + (cell + 0.5) * width, 84, str(cell), 15, BLUE, "middle", bold=True)
    p.text(left - 12, 84, "cell id", 15, BLUE, "end", bold=True)
    rows = [("last substep", before, {}),
            ("not cleared", stale, {4: (tint(ORANGE, 0.20), ORANGE, 3)}),
            ("clear_cells", empty_ranges(), {}),
            ("then build_grid", fresh, {4: (tint(GREEN, 0.20), GREEN, 3), 9: (tint(GREEN, 0.20), GREEN, 3)})]
    for index, (word, ranges, highlight) in enumerate(rows):
        top = 100 + index * 62
        p.text(left - 12, top + 23, word, 16, anchor="end", bold=index in (2, 3))
        range_row(p, left, top, ranges, cells, highlight, width)
    slots = range(*stale[4])
    there = ", ".join(f"slot {s} holds ball {keys[s][1]} of cell {keys[s][0]}" for s in slots)
    p.text(40, 376, f"Not cleared, cell 4 still claims {there}:", 17)
    p.text(40, 402, "balls near cell 4 would meet a ball that is elsewhere, and near both cells meet it twice.", 17)
    return p.finish()


def build_grid():
    keys, count = sorted_keys(), len(model.BALLS)
    ranges = model.build_grid(keys, count, empty_ranges())
    p = Picture(960, 430, "build_grid: only the slots at a boundary write")
    left, width, top = 110, 50, 78
    p.text(40, 36, "One thread a slot. It looks at its two neighbours; where the cell id changes, it writes.", 18)
    slot_numbers(p, left, top - 10, len(keys), width)
    key_row(p, left, top, keys, width)
    for slot in range(count):
        x = left + slot * width
        if slot == 0 or keys[slot - 1][0] != keys[slot][0]:
            p.line(x, top - 4, x, top + 72, INK, 3)
            p.arrow(x + 14, top + 58, x + 14, top + 96, BLUE, 2.5)
        if slot + 1 == count or keys[slot + 1][0] != keys[slot][0]:
            p.arrow(x + width - 12, top + 58, x + width - 12, top + 96, ORANGE, 2.5)
    p.line(left + count * width, top - 4, left + count * width, top + 72, INK, 3)
    y = top + 124
    p.arrow(left, y - 18, left, y + 10, BLUE, 2.5)
    p.text(left + 12, y + 4, "writes first = slot", 16)
    p.arrow(left + 190, y - 18, left + 190, y + 10, ORANGE, 2.5)
    p.text(left + 202, y + 4, "writes end = slot + 1", 16)
    two = next(c for c, (a, b) in enumerate(ranges) if b - a > 1)
    p.text(left + 400, y + 4, f"cell {two} has two balls: one slot writes first, another end", 16)
    for row in range(2):
        cells = range(row * 10, row * 10 + 10)
        top = 252 + row * 82
        for cell in cells:
            p.text(left + (cell % 10 + 0.5) * 80, top - 8, str(cell), 15, BLUE, "middle", bold=True)
            first, end = ranges[cell]
            p.rect(left + cell % 10 * 80, top, 80, 36, SHADE if first == end else "#ffffff", INK, 1.2)
            text = "–" if first == end else f"[{first}, {end})"
            p.text(left + (cell % 10 + 0.5) * 80, top + 24, text, 16, GREY if first == end else INK, "middle")
        p.text(left - 10, top - 8, "cell id", 15, BLUE, "end", bold=True)
        p.text(left - 10, top + 24, "range", 15, anchor="end")
    p.text(left, 402, "cell_ranges[]: the slots [first, end) hold the cell's balls; – is an empty cell, first = end = 0.", 16)
    return p.finish()


def collide():
    me = 3
    keys = sorted_keys()
    ranges = model.build_grid(keys, len(model.BALLS), empty_ranges())
    met = list(model.neighbours(me, keys, ranges))
    x, y = model.cell_of(model.BALLS[me])
    near = {model.cell_id((x + dx, y + dy)) for dx in (-1, 0, 1) for dy in (-1, 0, 1)}
    touching = {b for _, _, b in met if b != me and model.overlap(model.BALLS[me], model.BALLS[b]) > 0}
    p = Picture(960, 560, "collide: the balls that ball 3 looks at, and the forces on it")
    box = Box(p, 40, 40)
    box.cells(near)
    candidates = {b for _, _, b in met}

    def colours(i):
        if i == me:
            return tint(BLUE, 0.60), BLUE, 3
        if i in touching:
            return tint(ORANGE, 0.47), ORANGE, 3
        return (tint(AMBER, 0.33), AMBER, 2) if i in candidates else ("#ffffff", LINE, 1.5)
    box.balls(colours)
    mx, my, _ = model.BALLS[me]
    for b in touching:
        bx, by, _ = model.BALLS[b]
        length = ((mx - bx) ** 2 + (my - by) ** 2) ** 0.5
        start = box.place(mx, my)
        reach = 0.55
        end = box.place(mx + reach * (mx - bx) / length, my + reach * (my - by) / length)
        p.arrow(*start, *end, INK, 3.5, head=12)
    left, top = 500, 70
    p.text(left, top - 14, "Thread 3 walks the shaded cells, slot by slot:", 18, bold=True)
    for column, word in ((0, "cell"), (70, "slot"), (140, "ball"), (215, "overlap with ball 3")):
        p.text(left + column, top + 20, word, 15, GREY)
    for row, (cell, slot, b) in enumerate(met):
        line = top + 50 + row * 30
        depth = model.overlap(model.BALLS[me], model.BALLS[b])
        p.text(left, line, str(cell), 18, BLUE, bold=True)
        p.text(left + 70, line, str(slot), 18)
        p.text(left + 140, line, str(b), 18, bold=True)
        if b == me:
            p.text(left + 215, line, "itself: skipped", 16, GREY)
        elif depth > 0:
            p.text(left + 215, line, f"{depth:.3f} m", 17, ORANGE, bold=True)
        else:
            p.text(left + 215, line, "none", 16, GREY)
    line = top + 50 + len(met) * 30 + 22
    skipped = len(model.BALLS) - len(met)
    p.text(left, line, f"{len(met) - 1} candidates instead of {len(model.BALLS) - 1}; {skipped} balls are never looked at.", 17)
    p.text(left, line + 26, "The order is fixed, so the sum is, to the last bit.", 17)
    p.text(left, line + 52, "Arrows: k · overlap − c · speed, along the centres.", 17)
    p.text(left, line + 78, "In space it is 3 × 3 × 3 cells.", 17)
    top = 440
    for word, at, colour in (("positions, velocities", 60, SKY), ("next_positions, next_velocities", 590, GREEN)):
        p.rect(at, top, 310, 50, tint(colour, 0.27), colour, 2.5, 8)
        p.text(at + 155, top + 32, word, 18, anchor="middle", bold=True)
    p.arrow(370, top + 25, 440, top + 25, INK, 3)
    p.rect(440, top, 80, 50, "#ffffff", INK, 2.5, 8)
    p.text(480, top + 32, "collide", 18, anchor="middle", bold=True)
    p.arrow(520, top + 25, 590, top + 25, INK, 3)
    p.text(215, top + 78, "only read", 16, anchor="middle")
    p.text(745, top + 78, "only written; the roles change at the substep's end", 16, anchor="middle")
    return p.finish()


FIGURES = {"assign_cells": assign_cells, "bitonic_sort": bitonic_sort, "bitonic_sort_fused": bitonic_sort_fused,
           "clear_cells": clear_cells, "build_grid": build_grid, "collide": collide}
