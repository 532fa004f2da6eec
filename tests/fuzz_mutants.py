#!/usr/bin/env python3
"""Plants mistakes that only extremes show, and asks the property fuzz whether it finds them as soon as CTest's run of it.

fuzz_mutants.py [--folder FOLDER] [--only PART]
    copies the program to FOLDER (build/fuzz_mutants), spoils mirror and shaders, builds the fuzz and runs it on both.
fuzz_mutants.py --quick EXECUTABLE [--only PART]
    the shaders alone, without building: EXECUTABLE (ballpit_property_fuzz) on spoiled copies of glsl/. CTest does this.
Exit code 1 if a mistake lived.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True   # leaves the source tree as it is

import mutants

CPU_CASES, GPU_CASES = 1500, 60   # what CTest runs
CELLS = "std::clamp(coordinate, Real(0), last)"

# name; edits of the mirror; edits of the shaders (mutants.py has the form)
MUTANTS = [
    ("no guard for the distance zero",
     [("src/cpu/collider.h", "distance_squared > 0 ? offset / distance", "true ? offset / distance")],
     [("glsl/shared/pair.glsl", "distance_squared > 0.0 ? offset / separation", "true ? offset / separation")]),
    ("no clamp before the cell becomes a whole number",
     [("src/cpu/assign_cells.cpp", CELLS, "last < 0 ? last : coordinate")],
     [("glsl/shared/cells.glsl", f"clamp(coordinate.{axis}, 0.0, last.{axis})", f"coordinate.{axis}") for axis in "xyz"]),
]


def notice(executable, backend, environment=None):
    """The property that did not hold, or nothing."""
    cases = CPU_CASES if backend == "cpu" else GPU_CASES
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([executable, "--backend", backend, "--cases", str(cases), "--seconds", "600", "--failures", "1",
                              "--tries", "100", "--out", folder], env=environment, capture_output=True, text=True,
                             timeout=900, cwd=folder, check=False)
        saved = list(pathlib.Path(folder).glob("fuzz_*.json"))
    if run.returncode == mutants.EXIT_SKIPPED:
        print(run.stderr, file=sys.stderr)
        sys.exit(mutants.EXIT_SKIPPED)
    if run.returncode == 0:
        return ""
    lines = [line for line in run.stderr.splitlines() if "not so: " in line or "crashed" in line]
    if run.returncode != 1 or not lines or not (saved or "crashed" in lines[0]):
        sys.exit(f"fuzz_mutants.py: the fuzz failed otherwise: {run.stdout}{run.stderr}")
    return lines[0].split("not so: ")[-1]


def check_table():
    for name, host, shaders in MUTANTS:
        for file, right, _ in host + shaders:
            if right not in (mutants.ROOT / file).read_text(encoding="utf-8"):
                sys.exit(f"fuzz_mutants.py: '{name}' wants to change \"{right}\", which {file} no longer has")


def on_gpu(executable, shaders):
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder)
        shutil.copytree(mutants.ROOT / "glsl", copy / "glsl")
        mutants.spoil(copy, shaders)
        return notice(executable, "gpu", mutants.gpu_environment(copy / "glsl"))


def on_mirror(folder, host):
    mutants.copy_program(folder)
    mutants.spoil(folder, host)
    mutants.build(folder, ["ballpit_property_fuzz"])
    return notice(folder / "build" / "tests" / "ballpit_property_fuzz", "cpu")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", metavar="EXECUTABLE", type=pathlib.Path)
    parser.add_argument("--only", default="", help="mistakes whose name has this in it")
    parser.add_argument("--folder", type=pathlib.Path, default=mutants.ROOT / "build" / "fuzz_mutants")
    options = parser.parse_args()
    check_table()
    if not options.quick:
        options.folder.mkdir(parents=True, exist_ok=True)
        mutants.copy_program(options.folder)
        mutants.configure(options.folder)
        mutants.build(options.folder, ["ballpit_property_fuzz"])
        executable = options.folder / "build" / "tests" / "ballpit_property_fuzz"
        sound = shutil.copy2(executable, options.folder / "sound_fuzz")
        if notice(sound, "cpu") or notice(sound, "gpu", mutants.gpu_environment()):
            sys.exit("fuzz_mutants.py: the fuzz finds something without a mistake")
    lived = 0
    for name, host, shaders in MUTANTS:
        if options.only not in name:
            continue
        places = {} if options.quick else {"mirror": on_mirror(options.folder.resolve(), host)}
        places["GPU"] = on_gpu(options.quick.resolve() if options.quick else sound, shaders)
        for place, found in places.items():
            print(f"{name}, {place}: {found or 'LIVED'}", flush=True)
            lived += not found
    sys.exit(1 if lived else 0)


if __name__ == "__main__":
    main()
