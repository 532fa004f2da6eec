"""Pictures of the program: the substep as a list, who includes whom, and what was measured."""

import csv
import re
from pathlib import Path

import model
from svg import AMBER, BLUE, GREEN, GREY, INK, LINE, ORANGE, PINK, Axes, Picture, tint

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = {"app": (400, 66), "ui": (60, 190), "cpu": (285, 190), "gpu": (520, 190), "view": (750, 190),
           "measure": (60, 320), "gl": (780, 320), "core": (400, 450)}
ABOUT = {"app": "window, commands", "ui": "panels", "view": "drawing", "gpu": "executor", "cpu": "mirror",
         "gl": "GL objects", "measure": "checks, sums", "core": "data, schedule"}


def schedule():
    rows = model.schedule(5000)
    due = model.barriers(rows)
    slots = ["positions", "velocities", "keys", "cell_ranges", "status", "next_positions", "next_velocities"]
    p = Picture(960, 530, "The dispatches of a substep, what each reads and writes, and the barriers between them")
    p.text(40, 36, "One substep of 5000 balls (rain, bitonic_fused)", 18, bold=True)
    left, top, w, h = 400, 120, 76, 36
    for column, slot in enumerate(slots):
        x = left + (column + 0.5) * w
        high = 44 if column % 2 else 18
        p.text(x, top - high, slot, 15, anchor="middle")
        p.line(x, top - high + 6, x, top - 4, LINE, 1.5)
    for row, (name, _, reads, writes) in enumerate(rows):
        y = top + row * h
        if due[row]:
            p.line(40, y, left + len(slots) * w, y, ORANGE, 3)
        p.text(46, y + 24, f"{row + 1}", 15, GREY)
        p.text(76, y + 24, name, 16, bold=True)
        for column, slot in enumerate(slots):
            x = left + (column + 0.5) * w
            if slot in reads:
                p.circle(x - 12, y + h / 2, 8, "#ffffff", BLUE, 3)
            if slot in writes:
                p.rect(x + 4, y + h / 2 - 8, 16, 16, GREEN, GREEN)
    y = top + len(rows) * h + 34
    p.circle(60, y - 5, 8, "#ffffff", BLUE, 3)
    p.text(78, y, "reads", 16)
    p.rect(150, y - 13, 16, 16, GREEN, GREEN)
    p.text(174, y, "writes", 16)
    p.line(250, y - 5, 290, y - 5, ORANGE, 3)
    p.text(300, y, "barrier: a slot below was written above, or is written below and was read above", 16)
    return p.finish()


def includes():
    """(from, to) of every #include between the folders of src/."""
    found = set()
    for file in sorted((ROOT / "src").glob("*/*")):
        if file.suffix in (".h", ".cpp"):
            for to in re.findall(r'^#include "(\w+)/', file.read_text(encoding="utf-8"), re.MULTILINE):
                if to in FOLDERS and to != file.parent.name:
                    found.add((file.parent.name, to))
    return found


def layers():
    p = Picture(960, 540, "Which folder of src includes which")
    p.text(40, 36, "src/: an arrow means “includes” (found in the files)", 18, bold=True)
    w, h = 150, 62

    def edge(source, target):
        (ax, ay), (bx, by) = FOLDERS[source], FOLDERS[target]
        out, into = (max(-60.0, min(60.0, share * (bx - ax))) for share in (0.22, -0.12))
        p.arrow(ax + w / 2 + out, ay + h, bx + w / 2 + into, by, GREY, 2, None, 11)
    found = includes()
    below = {name: set(b for a, b in found if a == name) for name in FOLDERS}
    for source in FOLDERS:
        for target in sorted(below[source]):
            # What is reached over another folder is not drawn: the picture stays readable.
            if not any(target in below[via] for via in below[source]):
                edge(source, target)
    for name, (x, y) in FOLDERS.items():
        fill = {"core": tint(BLUE, 0.20), "gl": tint(AMBER, 0.27)}.get(name, "#ffffff")
        p.rect(x, y, w, h, fill, INK, 2, 8)
        p.text(x + w / 2, y + 27, name, 19, anchor="middle", bold=True)
        p.text(x + w / 2, y + 49, ABOUT[name], 15, GREY, "middle")
    p.text(600, 440, "Left out: what is reached over another folder too.", 14, GREY)
    p.text(600, 464, "gl knows nothing of ours;", 16)
    p.text(600, 488, "gpu and cpu do not know each other.", 16)
    return p.finish()


def rows_of(name):
    with open(ROOT / "docs" / "measurements" / name, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def performance():
    rows = rows_of("2026-11-22_h100_bench.csv")
    p = Picture(960, 560, "Milliseconds per substep and stage over the number of balls, NVIDIA H100")
    p.text(40, 38, "NVIDIA H100: ms a substep, median of 40 (rain)", 18, bold=True)
    axes = Axes(p, (90, 90, 600, 390), (1000, 1048576), (0.005, 5), log_x=True, log_y=True)
    axes.frame([(1000, "1000"), (5000, "5000"), (16384, "16 384"), (65536, "65 536"), (262144, "262 144"),
                (1048576, "1 048 576")], [(v, f"{v:g}") for v in (0.01, 0.1, 1)], "balls", "ms")
    curves = [("bitonic", "bitonic_sort", "sort, pass by pass", ORANGE, "9 4"),
              ("bitonic_fused", "bitonic_sort", "sort, fused", ORANGE, None),
              ("bitonic_fused", "collide", "collide", BLUE, None),
              ("bitonic_fused", "build_grid", "build_grid", GREEN, "3 3"),
              ("bitonic_fused", "assign_cells", "assign_cells", PINK, "12 5")]
    for sort, stage, word, colour, dash in curves:
        points = [(float(r["balls"]), float(r[stage])) for r in rows if r["sort"] == sort]
        axes.curve(points, colour, 3, dash)
        for point in points:
            p.circle(axes.x(point[0]), axes.y(point[1]), 4, colour, "none", 0)
        shift = {"collide": 14, "sort, pass by pass": -2}.get(word, 5)
        p.text(702, axes.y(points[-1][1]) + shift, f"{word}: {points[-1][1]:.3f}", 16, bold=True)
    return p.finish()


FIGURES = {"schedule": schedule, "layers": layers, "performance_h100": performance}
