"""Speed against accuracy, from the tables of `ballpit accuracy --csv`."""

from math import ceil, floor, log10, pi, exp

from project import rows_of
from svg import AMBER, BLUE, GREEN, GREY, INK, ORANGE, PINK, SKY, Axes, Picture

TWO_BALLS = "2026-11-22_cpu_accuracy_two_balls.csv"
FRONTS = [("pile", "2026-11-22_h100_accuracy_pile.csv"), ("elastic gas", "2026-11-22_h100_accuracy_elastic_gas.csv"),
          ("rain", "2026-11-22_h100_accuracy_rain.csv")]

INTEGRATORS = [("leapfrog", BLUE, None), ("symplectic_euler", GREEN, "3 3"), ("velocity_verlet", AMBER, "12 5"),
               ("historical", ORANGE, "9 4")]


def power(value):
    return f"{value:g}" if 0.01 <= value <= 1000 else f"1e{round(log10(value))}"


def decades(values):
    low, high = floor(log10(min(values))), ceil(log10(max(values)))
    return 10.0 ** low, 10.0 ** max(high, low + 1)


def ticks(low, high, most=8):
    first, last = round(log10(low)), round(log10(high))
    every = ceil((last - first) / most)
    return [(10.0 ** e, power(10.0 ** e)) for e in range(first, last + 1, every)]


def number(row, key):
    return float(row[key]) if row[key] else None


def curve(rows, x, y, **wanted):
    chosen = [r for r in rows if all(r[k] == v for k, v in wanted.items()) and r["finite"] == "true"]
    points = [(number(r, x), number(r, y)) for r in chosen]
    return sorted((a, b) for a, b in points if a and b)


def mark(p, axes, points, colour):
    for a, b in points:
        p.circle(axes.x(a), axes.y(b), 3.5, colour, "none", 0)


def contact():
    """Restitution error over substeps a contact."""
    rows = rows_of(TWO_BALLS)
    p = Picture(960, 560, "Restitution error over substeps per contact, by integrator")
    p.text(40, 38, "Two balls, elastic: 95 % of 64 phases err by less", 18, bold=True)
    curves = [(name, colour, dash, [(a, b) for a, b in curve(rows, "substeps_a_contact", "restitution_error",
                                                            integrator=name, precision="float") if 2 <= a <= 3000])
              for name, colour, dash in INTEGRATORS]
    y_range = decades([b for *_, points in curves for _, b in points])
    axes = Axes(p, (90, 90, 600, 390), (1, 10000), y_range, log_x=True, log_y=True)
    axes.frame(ticks(1, 10000), ticks(*y_range), "substeps a contact, Nc", "|e - 1|")
    for name, colour, dash, points in curves:
        axes.curve(points, colour, 3, dash)
        mark(p, axes, points, colour)
    law = [(n, exp(pi ** 2 / (4 * n)) - 1) for n in (2.5, 4000)]
    p.text(700, axes.y(law[-1][1]) - 6, "historical:", 16, ORANGE, bold=True)
    p.text(700, axes.y(law[-1][1]) + 14, "exp(π²/4Nc) - 1", 15)
    last = curves[0][3][-1]
    p.text(700, axes.y(last[1]) - 6, "leapfrog, symplectic Euler,", 16, BLUE, bold=True)
    p.text(700, axes.y(last[1]) + 14, "velocity Verlet: one curve", 15)
    return p.finish()


def float_floor():
    """The U: more substeps are worse once rounding rules."""
    rows = rows_of(TWO_BALLS)
    p = Picture(960, 560, "Position error over substeps: float has a floor, compensated sums do not")
    p.text(40, 38, "Two balls after one hit, 1 s: where they are, against the reference in double", 18, bold=True)
    wanted = [("historical", "float", ORANGE, "9 4", "historical"), ("symplectic_euler", "float", GREEN, "3 3", "symplectic Euler"),
              ("velocity_verlet", "float", AMBER, "12 5", "velocity Verlet"), ("leapfrog", "float", BLUE, None, "leapfrog"),
              ("leapfrog", "compensated", PINK, None, "leapfrog, compensated")]
    curves = [(colour, dash, word, curve(rows, "substeps", "position_error", integrator=name, precision=precision))
              for name, precision, colour, dash, word in wanted]
    y_range = decades([b for *_, points in curves for _, b in points])
    axes = Axes(p, (90, 90, 600, 390), (1, 100000), y_range, log_x=True, log_y=True)
    axes.frame(ticks(1, 100000), ticks(*y_range), "substeps a step of 1/60 s", "m (rms)")
    taken = []
    for colour, dash, word, points in curves:
        axes.curve(points, colour, 3, dash)
        mark(p, axes, points, colour)
        y = axes.y(points[-1][1])
        while any(abs(y - other) < 18 for other in taken):
            y += 18
        taken.append(y)
        p.text(700, y + 5, word, 16, colour, bold=True)
    p.line(axes.x(1), axes.y(1e-3), axes.x(100000), axes.y(1e-3), GREY, 1.5, "4 4")
    p.text(axes.x(100000) - 6, axes.y(1e-3) - 6, "1 mm", 14, GREY, "end")
    return p.finish()


def front_of(points):
    front = []
    for cost, error in sorted(points):
        if not front or error < front[-1][1]:
            front.append((cost, error))
    return front


def fronts():
    """Three scenes: energy made or eaten a second over the time that a simulated second takes."""
    p = Picture(1240, 520, "Pareto fronts of pile, elastic gas and rain")
    p.text(40, 38, "NVIDIA H100: energy error a second over ms for a simulated second; the line is the front", 18, bold=True)
    for i, (title, file) in enumerate(FRONTS):
        rows = rows_of(file)
        everything = [pt for name, *_ in INTEGRATORS for pt in curve(rows, "ms_a_second", "energy_error", integrator=name)]
        shown = [(a, min(b, 1e3)) for a, b in everything]
        x_range, y_range = decades([a for a, _ in shown]), decades([b for _, b in shown])
        axes = Axes(p, (80 + 400 * i, 110, 300, 320), x_range, y_range, log_x=True, log_y=True)
        axes.frame(ticks(*x_range, 4), ticks(*y_range), "ms", "")
        p.text(80 + 400 * i, 90, title, 17, bold=True)
        for name, colour, _ in INTEGRATORS:
            for precision, fill in (("float", colour), ("compensated", "none")):
                for a, b in curve(rows, "ms_a_second", "energy_error", integrator=name, precision=precision):
                    p.circle(axes.x(a), axes.y(min(b, 1e3)), 4.5, fill, colour, 1.5)
            for a, b in curve(rows, "ms_a_second", "energy_error", integrator=name, grid_reuse="8"):
                p.circle(axes.x(a), axes.y(min(b, 1e3)), 2, INK, "none", 0)
        axes.curve(front_of(shown), INK, 1.5)
    for i, (name, colour, _) in enumerate(INTEGRATORS):
        p.circle(90 + 210 * i, 492, 5, colour, colour, 1.5)
        p.text(102 + 210 * i, 497, name.replace("_", " "), 15)
    p.circle(890, 492, 5, "none", BLUE, 1.5)
    p.text(902, 497, "compensated", 15)
    p.circle(1010, 492, 5, BLUE, BLUE, 1.5)
    p.circle(1010, 492, 2, INK, "none", 0)
    p.text(1022, 497, "one grid for 8 substeps", 15)
    return p.finish()


FIGURES = {"accuracy_contact": contact, "accuracy_floor": float_floor, "accuracy_fronts": fronts}
