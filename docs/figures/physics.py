"""Pictures of time: when velocities live, what integrators do to energy, what a contact does to force."""

from math import exp, sqrt

import model
from svg import AMBER, BLUE, GREEN, GREY, INK, LINE, ORANGE, PINK, Axes, Picture


def synchronise():
    p = Picture(960, 400, "Leapfrog: velocities live half a substep before positions, until a kick synchronises them")
    left, step, xs, vs = 150, 180, 150, 260
    p.text(40, 40, "Leapfrog: a kick moves the velocity in time, a drift moves the position.", 18, bold=True)
    for i in range(5):
        t = left + i * step
        p.line(t, 84, t, 322, LINE, 1, "5 5")
        p.text(t, 346, "t = 0" if i == 0 else f"{i} dt", 16, anchor="middle")
    p.text(40, xs + 6, "position", 18, BLUE, bold=True)
    p.text(40, vs + 6, "velocity", 18, ORANGE, bold=True)
    for i in range(4):
        p.arrow(left + i * step + 14, xs, left + (i + 1) * step - 14, xs, BLUE, 2.5)
    for i in range(5):
        p.circle(left + i * step, xs, 11, BLUE, BLUE)
    p.circle(left, vs, 11, "#ffffff", ORANGE, 3)
    p.arrow(left + 14, vs, left + step / 2 - 14, vs, ORANGE, 2.5)
    for i in range(4):
        p.circle(left + (i + 0.5) * step, vs, 11, ORANGE, ORANGE)
        if i < 3:
            p.arrow(left + (i + 0.5) * step + 14, vs, left + (i + 1.5) * step - 14, vs, ORANGE, 2.5)
    p.text(left + step / 4, vs + 36, "half kick", 16, anchor="middle")
    p.text(left + step, vs - 18, "kick", 16, anchor="middle")
    p.text(left + step / 2, xs - 20, "drift", 16, anchor="middle")
    end = left + 4 * step
    p.arrow(left + 3.5 * step + 14, vs, end - 14, vs, GREEN, 3, "7 4")
    p.circle(end, vs, 11, "#ffffff", GREEN, 3)
    p.text(end - step / 4, vs + 36, "synchronise", 16, GREEN, "middle", bold=True)
    p.text(left + 3.5 * step, vs - 58, "velocity_lag = dt / 2", 16, anchor="middle")
    p.line(left + 3.5 * step, vs - 44, end, vs - 44, INK, 1.5)
    p.line(left + 3.5 * step, vs - 50, left + 3.5 * step, vs - 38, INK, 1.5)
    p.line(end, vs - 50, end, vs - 38, INK, 1.5)
    p.text(left, 384, "The first kick is short because the start has no lag. Synchronise is a kick without a drift: nothing moves.", 16)
    return p.finish()


def integrators():
    h, count = 0.2, 190          # w dt, substeps: about six periods
    w, dt = 1.0, 0.2
    p = Picture(960, 520, "Energy of a spring under five integrators")
    p.text(40, 38, f"A ball on a spring, no drag: its energy should stay 1. ω dt = {h}, {count} substeps.", 18, bold=True)
    axes = Axes(p, (90, 86, 620, 350), (0, count), (0.5, 5000), log_y=True)
    axes.frame([(n, str(n)) for n in range(0, count + 1, 38)], [(1, "1"), (10, "10"), (100, "100"), (1000, "1000")],
               "substeps", "energy / energy at the start")
    styles = {"forward_euler": (ORANGE, None), "historical": (PINK, "9 4"), "symplectic_euler": (AMBER, "3 3"),
              "velocity_verlet": (GREEN, "12 5"), "leapfrog": (BLUE, None)}
    ends, ranges = {}, {}
    for name, (colour, dash) in styles.items():
        energies = [x * x + v * v / (w * w) for x, v in model.substeps(name, lambda x: -w * w * x, 1.0, 0.0, dt, count)]
        axes.curve(list(enumerate(energies)), colour, 3, dash)
        ends[name], ranges[name] = energies[-1], (min(energies), max(energies))
    for name in ("forward_euler", "historical"):
        at = axes.y(ends[name])
        p.text(722, at + 6, f"{name}: × {ends[name]:.0f}", 16, bold=True)
    y = axes.y(1) - 76
    for name in ("symplectic_euler", "velocity_verlet", "leapfrog"):
        low, high = ranges[name]
        colour, dash = styles[name]
        p.line(722, y - 5, 752, y - 5, colour, 3, dash)
        p.text(758, y, f"{name}", 16, bold=True)
        p.text(758, y + 19, f"{low:.3f} to {high:.3f}", 15, GREY)
        y += 46
    assert abs(ends["historical"] / (1 + h * h / 2) ** count - 1) < 0.2
    p.text(90, 506, "Historical multiplies the energy by about 1 + (ω dt)²/2 in every substep, forward Euler by 1 + (ω dt)².", 16)
    return p.finish()


def wall_contact(zeta, limit_force, h=0.0005):
    """(time, overlap, force) of a unit ball that meets a wall with speed 1 (k = m = 1), in small leapfrog steps."""
    x, v, points, t = 0.0, 1.0, [], 0.0
    while True:
        force = x + 2 * zeta * v
        if limit_force:
            force = max(force, 0.0)
        points.append((t, x, force))
        v -= h * force
        x += h * v
        t += h
        if x < 0:
            return points, -v


def contact():
    e = 0.6
    p = Picture(960, 500, "Force of a contact with a wall over time")
    p.text(40, 38, "A ball meets a wall: the force while they touch.", 18, bold=True)
    axes = Axes(p, (90, 84, 560, 320), (0, 3.3), (-0.4, 1.2))
    axes.frame([(t, str(t)) for t in (0, 1, 2, 3)], [(v, str(v)) for v in (-0.4, 0, 0.4, 0.8, 1.2)],
               "time · √(k / m)", "force / (speed · √(k m))")
    p.line(90, axes.y(0), 650, axes.y(0), INK, 1.5)
    rows = []
    for word, zeta, limit, colour, dash in (
            ("restitution 1", 0.0, True, GREY, "3 4"),
            (f"restitution {e}", model.damping_ratio(e, True), True, BLUE, None),
            (f"restitution {e}, limit_force off", model.damping_ratio(e, False), False, ORANGE, "10 5")):
        points, speed = wall_contact(zeta, limit)
        axes.curve([(t, f) for t, _, f in points[::20]] + [(points[-1][0], points[-1][2])], colour, 3.5, dash)
        rows.append((word, zeta, speed, colour, dash))
        assert abs(speed - (e if zeta else 1.0)) < 2e-3, (word, speed)
    y = 130
    for word, zeta, speed, colour, dash in rows:
        p.line(680, y - 6, 720, y - 6, colour, 3.5, dash)
        p.text(730, y, word, 16, bold=True)
        p.text(730, y + 22, f"damping ratio ζ = {zeta:.4f}", 15)
        p.text(730, y + 43, f"leaves at {speed:.3f} of its speed", 15)
        y += 92
    p.text(40, 482, "Off, the dashpot pulls before the ball leaves (force below 0), so the same restitution needs another ζ.", 16)
    return p.finish()


FIGURES = {"synchronise": synchronise, "integrators": integrators, "contact": contact}
