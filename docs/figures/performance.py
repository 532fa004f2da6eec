"""Times of `ballpit bench --scene bench_pile --csv`: a figure and tables for every machine that has a file.

docs/measurements/DATE_MACHINE_bench_pile.csv (counts, states, sorts) and DATE_MACHINE_bench_drawn.csv (with --draw); of each machine
the newest of each kind. The tables go into docs/performance.md, between the two marks."""

import re
from math import log

from accuracy import decades, ticks
from project import ROOT, rows_of
from svg import AMBER, BLUE, GREEN, ORANGE, PINK, SKY, Axes, Picture

PAGE = ROOT / "docs" / "performance.md"
BEGIN, END = "<!-- made by docs/figures/make.py: begin -->\n", "<!-- made by docs/figures/make.py: end -->\n"
COLOURS = [(ORANGE, "9 4"), (BLUE, None), (GREEN, "3 3"), (PINK, "12 5"), (AMBER, "6 6"), (SKY, "2 5")]


def files(kind):
    """Machine -> newest file of this kind."""
    found = {}
    for path in sorted((ROOT / "docs" / "measurements").glob(f"*_{kind}.csv")):
        match = re.fullmatch(rf"\d{{4}}-\d\d-\d\d_([a-z0-9]+)_{kind}\.csv", path.name)
        if match:
            found[match[1]] = path.name
    return found


def stages_of(rows):
    """The stages are the columns between the wall clock's and the first rate."""
    names = list(rows[0])
    return names[names.index("wall_ms_per_substep") + 1:next(i for i, n in enumerate(names) if n.endswith("_gb_s"))]


def settled(rows):
    return [row for row in rows if row["state"] == "settled"] or rows


def by_sort(rows, column="ms_per_substep"):
    """Sort -> [(balls, ms)], without what was impossible."""
    curves = {}
    for row in rows:
        if row[column]:
            curves.setdefault(row["sort"], []).append((float(row["balls"]), float(row[column])))
    return {sort: sorted(points) for sort, points in curves.items()}


def slope(points):
    """Of the straight line through the last three in the logarithms (least squares); 0 for a single point."""
    xy = [(log(a), log(b)) for a, b in points[-3:]]
    mean = [sum(v) / len(xy) for v in zip(*xy)]
    across = sum((x - mean[0]) ** 2 for x, _ in xy)
    return sum((x - mean[0]) * (y - mean[1]) for x, y in xy) / across if across else 0.0


def count(balls):
    return f"{int(balls):,}".replace(",", "\u2009")


def shown(ms):
    return f"{ms:.3f}" if ms < 1 else f"{ms:.2f}" if ms < 100 else f"{ms:.0f}"


def best_sort(rows):
    """The quickest at the largest count."""
    most = max(float(row["balls"]) for row in rows)
    return min(((points[-1][1], sort) for sort, points in by_sort(rows).items() if points[-1][0] == most))[1]


def draw_curves(p, axes, curves, x):
    labels = []
    for (colour, dash), (name, points) in zip(COLOURS, curves.items()):
        axes.curve(points, colour, 3, dash)
        for a, b in points:
            p.circle(axes.x(a), axes.y(b), 4, colour, "none", 0)
        text = f"{name}: {shown(points[-1][1])}, slope {slope(points):.2f}"
        labels.append((axes.y(points[-1][1]) + 5, text, colour))
    below = 0.0
    for y, text, colour in sorted(labels):
        below = max(y, below + 20)
        p.text(x, below, text, 15, colour, bold=True)


def figure(machine):
    rows = settled(rows_of(files("bench_pile")[machine]))
    sort = best_sort(rows)
    one = [row for row in rows if row["sort"] == sort]
    stages = {name: by_sort(one, name)[sort] for name in stages_of(rows) if by_sort(one, name)}
    title = f"{rows[0]['device']}: ms a substep over balls, settled pile"
    p = Picture(1240, 520, title)
    p.text(40, 38, title, 18, bold=True)
    counts = sorted({float(row["balls"]) for row in rows})
    x_range = (counts[0], counts[-1])
    x_ticks = [(v, count(v)) for v in counts[::2 if len(counts) > 5 else 1]]
    for left, word, curves in ((80, "whole substep, by sort", by_sort(rows)), (690, f"stages with {sort}", stages)):
        curves = {key: points for key, points in curves.items() if all(b > 0 for _, b in points)}
        y_range = decades([b for points in curves.values() for _, b in points])
        axes = Axes(p, (left, 120, 310, 310), x_range, y_range, log_x=True, log_y=True)
        axes.frame(x_ticks, ticks(*y_range), "balls", "ms")
        p.text(left + 40, 84, word, 17, bold=True)
        draw_curves(p, axes, curves, left + 320)
    return p.finish()


def stage_text(row, name, text):
    """Nothing where the stage did not run, a dash where its time cannot be true."""
    if not row[name]:
        return "–"
    return text(float(row[name])) if float(row[name]) > 0 else ""


def rate_text(gb_s):
    return f"{gb_s:,.0f}".replace(",", " ") if gb_s >= 100 else f"{gb_s:.3g}"


def table_of_times(rows):
    stages = stages_of(rows)
    lines = [f"| balls | sort | substep | quartiles | {' | '.join(stages)} |",
             "| ---: | --- | ---: | --- |" + " ---: |" * len(stages)]
    for row in rows:
        times = [stage_text(row, name, shown) for name in stages]
        whole = f"**{shown(float(row['ms_per_substep']))}**" if row["ms_per_substep"] else "–"
        spread = f"{shown(float(row['q1']))} – {shown(float(row['q3']))}"
        lines.append(f"| {count(row['balls'])} | {row['sort']} | {whole} | {spread} | {' | '.join(times)} |")
    return lines


def table_of_rates(rows):
    """Bytes and rates of the quickest sort."""
    sort = best_sort(rows)
    stages = stages_of(rows)
    lines = [f"| balls | candidates | contacts | copy, GB/s | buffers, B a ball | cell table, B a ball | {' | '.join(stages)} |",
             "| ---: | ---: | ---: | ---: | ---: | ---: |" + " ---: |" * len(stages)]
    for row in (row for row in rows if row["sort"] == sort):
        balls = float(row["balls"])
        copy = float(row["copy_gb_s"])
        shares = [stage_text(row, n + "_gb_s", lambda rate: f"{rate_text(rate)} ({100 * rate / copy:.0f} %)") for n in stages]
        lines.append(f"| {count(balls)} | {float(row['candidates']):.1f} | {float(row['contacts']):.1f} | "
                     f"{rate_text(copy)} | {float(row['bytes_per_ball']):.0f} | {float(row['cell_table_bytes']) / balls:.0f} | "
                     f"{' | '.join(shares)} |")
    return lines


def section(machine):
    name = files("bench_pile")[machine]
    every = rows_of(name)
    rows = settled(every)
    first = rows[0]
    lines = [f"## {first['device']}", f"{first['driver']}, {first['date'][:10]}; medians of {first['steps']} steps, ms. "
             f"[{name}](measurements/{name}), made by", "```", first["command"], "```",
             f"![milliseconds over balls](images/performance_{machine}_pile.svg)", "",
             f"Settled pile (state `{first['state']}`):", ""]
    lines += table_of_times(rows)
    lines += ["", f"The same with `{best_sort(rows)}`: what has to be looked at, how fast this device copies as much as the state, memory, "
              "and GB/s of the bytes that a stage cannot do without, in brackets over that of the copy:", ""]
    lines += table_of_rates(rows)
    falling = [row for row in every if row["state"] == "start"]
    if falling and rows is not every:
        lines += ["", "Falling, at the start of the scene:", ""] + table_of_times(falling)
    return lines + [""] + drawn(machine)


def drawn(machine):
    if machine not in files("bench_drawn"):
        return []
    name = files("bench_drawn")[machine]
    rows = rows_of(name)
    lines = [f"With a picture of 1920 × 1080 ([{name}](measurements/{name})), `{rows[0]['command']}`:", "",
             "| balls | state | substeps | frame, ms | of that the picture | frames a second (wall clock) |",
             "| ---: | --- | ---: | ---: | ---: | ---: |"]
    for row in rows:
        lines.append(f"| {count(row['balls'])} | {row['state']} | {row['substeps']} | {shown(float(row['frame_ms']))} | "
                     f"{shown(float(row['picture_ms']))} | {1000 / float(row['wall_frame_ms']):.0f} |")
    return lines + [""]


def page():
    """The page with its tables made anew."""
    text = PAGE.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    lines = [line for machine in files("bench_pile") for line in section(machine)]
    return before + BEGIN + "".join(line + "\n" for line in lines) + END + after


FIGURES = {f"performance_{machine}_pile": (lambda machine=machine: figure(machine)) for machine in files("bench_pile")}
