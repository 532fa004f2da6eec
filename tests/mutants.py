#!/usr/bin/env python3
"""Plants known mistakes one by one, and asks the analytic cases (docs/accuracy.md) whether they notice.

mutants.py [--only PART] [--folder FOLDER] [--gpu all|quick]
    copies the program to FOLDER (build/mutants), and for each mistake: spoils mirror, shaders and core, builds the
    executables of the analytic cases, runs them, and prints which cases turned red. Exit code 1 if a mistake lived.
    With --gpu quick the GPU is asked for mistakes in shaders only, and for the one or two cases of CTest.
mutants.py --quick EXECUTABLE
    only those in shaders, without building: runs EXECUTABLE (ballpit_physics_gpu_tests) over spoiled copies of glsl/,
    one or two cases each. This is what CTest runs.
"""
import argparse
import datetime
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

EXIT_SKIPPED = 77   # the executables' own: no OpenGL 4.3 here
ROOT = pathlib.Path(__file__).resolve().parents[1]
LIVED = "**lived**"
CPU = "src/cpu/collider.h"
NEIGHBOURS = "src/cpu/neighbours.h"
PAIR = "glsl/shared/pair.glsl"
CONTACT = "glsl/shared/contact.glsl"

# name; edits of the mirror and the core: (file, right, wrong); edits of the shaders; a case that notices it on the GPU.
MUTANTS = [
    ("drag speeds up",
     [(CPU, "kick.decay * v + kick.gain * a : v", "(Real(2) - kick.decay) * v + kick.gain * a : v")],
     [("glsl/collide.comp", "params.decay * v + params.gain * a", "(2.0 - params.decay) * v + params.gain * a")],
     "A3*"),
    ("drag of the squared substep",
     [("src/core/integrator.cpp", "const double exponent = -drag * duration;",
       "const double exponent = -drag * duration * duration;")], [], ""),
    ("half a substep is a whole one",
     [("src/core/integrator.cpp", "const double half = 0.5 * dt;", "const double half = dt;")], [], ""),
    ("half a substep is a quarter",
     [("src/core/integrator.cpp", "const double half = 0.5 * dt;", "const double half = 0.25 * dt;")], [], ""),
    ("historical without its 1/2",
     [(CPU, "(Real(0.5) * params.drift * params.drift) * a", "(params.drift * params.drift) * a")],
     [("glsl/collide.comp", "(0.5 * params.drift * params.drift) * a", "(params.drift * params.drift) * a")],
     "A1 *"),
    ("positions are read after they are written",
     [(CPU, "out.next_positions[id] = Vec4<Real>(x, radius);",
       "out.next_positions[id] = Vec4<Real>(x, radius);\n"
       "        const_cast<Vec4<Real>&>(in.positions[id]) = out.next_positions[id];")],
     [("glsl/collide.comp", "writeonly buffer NextPositionsBlock", "buffer NextPositionsBlock"),
      (PAIR, "vec4 position = positions[place];", "vec4 position = next_positions[place];")],
     "A4 head*"),
    ("a ball touches itself",
     [(NEIGHBOURS, "id = keys[slot].ball_id; id != self) {", "id = keys[slot].ball_id; true) {")],
     [("glsl/shared/neighbours.glsl", "within_reach(a, slot) && slot != a.place", "within_reach(a, slot)")],
     "A4 head*"),
    ("26 of 27 cells",
     [(NEIGHBOURS, "id = keys[slot].ball_id; id != self) {",
       "id = keys[slot].ball_id; id != self && !(x > middle.x && y > middle.y && z > middle.z)) {")],
     [("glsl/shared/neighbours.glsl", "ranges[2] = cell_ranges",
       "ranges[2] = y > middle.y && z > middle.z ? CellRange(0u, 0u) : cell_ranges")],
     "A25 forces*"),
    ("cells of the mean radius",
     [("src/core/world.cpp", "largest = std::max(largest, std::abs(position.w));",
       "largest += std::abs(position.w) / static_cast<float>(balls.positions.size());")], [], ""),
    ("cells half as wide",
     [("src/core/grid.cpp", "2.0 * r_max * cell_factor", "r_max * cell_factor")], [], ""),
    ("the mass of the other ball is one's own",
     [(CPU, "const Real mass = mass_of(velocity);", "const Real mass = a.mass;")],
     [(PAIR, "float mass = mass_of(velocity);", "float mass = a.mass;")],
     "A15 oblique with*"),
    ("the radius of the other ball is one's own",
     [(CPU, "a.radius + radius_of(position)", "a.radius + a.radius")],
     [(PAIR, "a.radius + radius_of(position)", "a.radius + a.radius")],
     "A5*"),
    ("the dashpot sees the whole velocity",
     [(CPU, "const Real speed = dot(a.velocity - Vec3<Real>(velocity), normal);",
       "const Vec3<Real> w = a.velocity - Vec3<Real>(velocity);\n"
       "        const Real speed = std::copysign(std::sqrt(dot(w, w)), dot(w, normal));")],
     [(PAIR, "precise float speed = ordered_dot(a.velocity - velocity.xyz, normal);",
       "vec3 w = a.velocity - velocity.xyz;\n    float speed = length(w) * sign(dot(w, normal));")],
     "A15 oblique with*"),
    ("a contact may pull",
     [(CPU, "? std::max(force, Real(0)) : force", "? force : force")],
     [(CONTACT, "force = max(force, 0.0);", "force = force;")],
     "A7*"),
    ("a pair counts twice",
     [(CPU, "force += pair_force(a, other, normal, reach - distance) * normal;",
       "force += Real(2) * pair_force(a, other, normal, reach - distance) * normal;")],
     [(PAIR, "force + pair_force(a, place, normal, overlap) * normal",
       "force + 2.0 * pair_force(a, place, normal, overlap) * normal")],
     "A4 head*"),
    ("no upper walls",
     [(CPU, "force[axis] -= wall_force(ball, high, -from_high[axis]);",
       "force[axis] -= Real(0) * wall_force(ball, high, -from_high[axis]);")],
     [("glsl/shared/walls.glsl", "pushed = pushed - wall_force(high[axis], -from_high[axis], ball);", "")],
     "A16*"),
    ("a substep lasts a step",
     [("src/core/simulation.cpp",
       "substep_motion(settings.integrator, drag(settings), substep_dt(settings), run_.velocity_lag)",
       "substep_motion(settings.integrator, drag(settings), settings.dt, run_.velocity_lag)"),
      ("src/core/simulation.cpp",
       "substep_motion(run_.settings.integrator, drag(run_.settings), substep_dt(run_.settings), run_.velocity_lag)",
       "substep_motion(run_.settings.integrator, drag(run_.settings), run_.settings.dt, run_.velocity_lag)")], [], ""),
    ("time is summed in float",
     [("src/core/simulation.cpp",
       "return run_.time_base + static_cast<double>(run_.substeps_since_base) * substep_dt(run_.settings);",
       "float t = static_cast<float>(run_.time_base);\n"
       "    for (std::uint64_t i = 0; i < run_.substeps_since_base; ++i) {\n"
       "        t += static_cast<float>(substep_dt(run_.settings));\n"
       "    }\n"
       "    return static_cast<double>(t);")], [], ""),
    ("gravity once a contact",
     [(CPU, "force += pair_force(a, other, normal, reach - distance) * normal;",
       "force += pair_force(a, other, normal, reach - distance) * normal;\n"
       "        force += features.has(Feature::gravity) ? a.mass * params.gravity : Vec3<Real>(0);")],
     [(PAIR, "force = sum;", "force = sum;\n#ifdef LAW_GRAVITY\n        force += a.mass * params.gravity;\n#endif")],
     "A10 column at rest*"),
    ("at most four balls of a cell",
     [(NEIGHBOURS, "slot < range.end; ++slot", "slot < std::min(range.end, range.first + 4u); ++slot")],
     [("glsl/shared/neighbours.glsl", "slot < rows[row].end; ++slot",
       "slot < min(rows[row].end, rows[row].first + 4u); ++slot")],
     "A25 forces*"),
    ("counting sort: two balls have one ticket",
     [("src/cpu/scatter_keys.cpp", ".first + tickets[ball]]", ".first + tickets[ball] / 2]")],
     [("glsl/scatter_keys.comp", ".first + tickets[place];", ".first + tickets[place] / 2u;")],
     "A25 forces*"),
    ("counting sort: a cell begins in the last slot of the one before",
     [("src/cpu/scan_cells.cpp", "next += count;", "next += count - 1;")],
     [("glsl/scan_cells.comp", "first += count;", "first += count - min(count, 1u);")],
     "A25 forces*"),
    ("counting sort: keys of a cell are left out",
     [("src/cpu/order_keys.cpp", "scattered_keys.subspan(range.first, slots.size())",
       "scattered_keys.subspan(range.first, slots.size() / 2)")],
     [("glsl/order_keys.comp", ".ball_id < key.ball_id", ".ball_id <= key.ball_id")],
     "A25 forces*"),
]


def spoil(root, edits):
    """Applies the edits below `root`, wherever the text occurs."""
    for name, right, wrong in edits:
        file = root / name
        file.write_text(file.read_text(encoding="utf-8").replace(right, wrong), encoding="utf-8")


def check_table():
    for name, host, shaders, _ in MUTANTS:
        for file, right, _ in host + shaders:
            if right not in (ROOT / file).read_text(encoding="utf-8"):
                sys.exit(f"mutants.py: '{name}' wants to change \"{right}\", which {file} no longer has")


def cases_that_fail(executable, arguments, environment):
    """The failed test cases: their numbers, like A4, or their names."""
    run = subprocess.run([executable, "-r", "xml", *arguments], env=environment, capture_output=True, text=True,
                         timeout=900, cwd=ROOT)
    if run.returncode == EXIT_SKIPPED:
        print(run.stderr, file=sys.stderr)
        sys.exit(EXIT_SKIPPED)
    failed = []
    for case in re.split(r"<TestCase ", run.stdout)[1:]:
        name = re.match(r'name="([^"]*)"', case).group(1)
        if '<OverallResult success="false"' in case or "<OverallResult" not in case:
            number = re.match(r"A\d+(, A\d+)?", name)
            failed.append(number.group(0) if number else name.split(" - ")[0])
    if run.returncode != 0 and not failed:
        failed.append(f"exit code {run.returncode}")
    return sorted(set(failed), key=lambda name: (name[0] != "A", int(re.sub(r"\D.*", "", name[1:]) or 0), name))


def gpu_environment(shaders=None):
    environment = dict(os.environ, SDL_VIDEODRIVER="offscreen")
    if shaders:
        environment["BALLPIT_TEST_SHADERS"] = str(shaders)
    return environment


def quick(executable):
    lived = []
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder)
        for name, _, shaders, case in MUTANTS:
            if not shaders:
                continue
            shutil.rmtree(copy / "glsl", ignore_errors=True)
            shutil.copytree(ROOT / "glsl", copy / "glsl")
            spoil(copy, shaders)
            failed = cases_that_fail(executable, [case], gpu_environment(copy / "glsl"))
            print(f"{name}: {', '.join(failed) or 'LIVED'}", flush=True)
            if not failed:
                lived.append(name)
    return lived


def build(folder, targets):
    subprocess.run(["cmake", "--build", str(folder / "build"), "--target", *targets], check=True,
                   stdout=subprocess.DEVNULL)


def copy_program(folder):
    """A copy of what is built, in which only changed files get a new date."""
    for name in ("CMakeLists.txt", "cmake", "src", "glsl", "tests", "assets"):
        source = ROOT / name
        for file in [source] if source.is_file() else source.rglob("*"):
            target = folder / file.relative_to(ROOT)
            if file.is_dir():
                target.mkdir(parents=True, exist_ok=True)
            elif not target.is_file() or target.read_bytes() != file.read_bytes():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(file, target)


def configure(folder):
    command = ["cmake", "-S", str(folder), "-B", str(folder / "build"), "-DCMAKE_BUILD_TYPE=Release"]
    command += ["-G", "Ninja"] if shutil.which("ninja") else []
    command += ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def red_on_gpu(executable, shaders, case, quickly):
    """Cell of the table; mistakes in the core alone are the same code on both sides, and are asked for with all."""
    if quickly and not shaders:
        return "the same code"
    return ", ".join(cases_that_fail(executable, [case] if quickly else [], gpu_environment())) or LIVED


def full(folder, only, quickly):
    folder.mkdir(parents=True, exist_ok=True)
    targets = ["ballpit_physics_tests", "ballpit_physics_gpu_tests"]
    copy_program(folder)
    configure(folder)
    build(folder, targets)
    cpu, gpu = (folder / "build" / "tests" / target for target in targets)
    for executable, environment in ((cpu, None), (gpu, gpu_environment())):
        failed = cases_that_fail(executable, [], environment)
        if failed:
            sys.exit(f"mutants.py: {executable.name} fails without a mistake: {', '.join(failed)}")
    if quickly:  # what is linked now reads its shaders anew
        targets = targets[:1]
    rows = []
    for name, host, shaders, case in MUTANTS:
        if only not in name:
            continue
        copy_program(folder)
        spoil(folder, host + shaders)
        build(folder, targets)
        on_cpu = ", ".join(cases_that_fail(cpu, [], None)) or LIVED
        rows.append(f"| {name} | {on_cpu} | {red_on_gpu(gpu, shaders, case, quickly)} |")
        print(rows[-1], file=sys.stderr, flush=True)
    copy_program(folder)
    command = "./run mutants" + (" --gpu quick" if quickly else "")
    print(f"Made by `{command}` on {datetime.date.today().isoformat()}.\n")
    print("| mistake | red on mirror and reference | red on the GPU |\n| --- | --- | --- |")
    print("\n".join(rows))
    return [row for row in rows if LIVED in row]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", metavar="EXECUTABLE", type=pathlib.Path)
    parser.add_argument("--only", default="", help="mistakes whose name has this in it")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "mutants")
    parser.add_argument("--gpu", choices=["all", "quick"], default="all")
    options = parser.parse_args()
    check_table()
    if options.quick:
        lived = quick(options.quick.resolve())
    else:
        lived = full(options.folder.resolve(), options.only, options.gpu == "quick")
    if lived:
        sys.exit("mutants.py: nobody noticed:\n" + "\n".join(lived))


if __name__ == "__main__":
    main()
