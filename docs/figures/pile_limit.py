"""Piles at rest with substeps around the largest stable one, from the table of `./run pile-limit`."""

from accuracy import ticks
from project import rows_of
from svg import AMBER, BLUE, GREEN, GREY, INK, ORANGE, PINK, SKY, Axes, Picture

TABLE = "2026-11-22_cpu_pile_limit.csv"
CURVES = [("0.25", GREY, "3 3"), ("0.9", SKY, None), ("0.95", GREEN, "12 5"), ("0.99", BLUE, None), ("1.01", AMBER, "9 4"),
          ("1.02", PINK, None), ("1.05", ORANGE, None), ("1.1", INK, "6 3")]
PANELS = [("equal", "1", "equal radii, no loss"), ("1:2", "1", "radii 1:2, no loss"),
          ("equal", "0.5", "equal radii, e = 0.5"), ("1:2", "0.5", "radii 1:2, e = 0.5")]
HIGH = 1e4


def panel(p, axes, rows, title):
    axes.frame([(10.0 ** e, f"{10 ** e}") for e in range(1, 5)], ticks(1e-10, HIGH, 7), "substeps", title)
    ends = []
    for share, colour, dash in CURVES:
        points = [(float(r["substeps"]), min(float(r["largest_kinetic_mgr"]), HIGH)) for r in rows
                  if r["share_of_critical"] == share]
        axes.curve(points, colour, 2.5, dash)
        ends.append((points[-1][1], share, colour))
    y = axes.box[1] + axes.box[3] + 16
    for value, share, colour in sorted(ends):       # from below, so that labels stand in the order of the curves
        y = min(y - 16, axes.y(value) + 5)
        p.text(axes.box[0] + axes.box[2] + 8, y, share, 14, colour, bold=True)


def pile_limit():
    """Agitation over substeps: nothing below dt_c, exponential growth above."""
    rows = rows_of(TABLE)
    p = Picture(1180, 920, "Kinetic energy of piles at rest over substeps, for substeps around the critical one")
    p.text(40, 38, "300 balls at rest: largest kinetic energy so far over Σ m g r, at dt / dt_c =", 18, bold=True)
    for i, (radii, restitution, title) in enumerate(PANELS):
        mine = [r for r in rows if r["radii"] == radii and r["restitution"] == restitution]
        box = (90 + 560 * (i % 2), 120 + 410 * (i // 2), 420, 310)
        panel(p, Axes(p, box, (5, 10000), (1e-10, HIGH), log_x=True, log_y=True), mine, title)
    return p.finish()


FIGURES = {"accuracy_pile_limit": pile_limit}
