"""The built program from outside: exit codes, one sentence on stderr for bad input, no half-written files.

Usage: command_line_test.py PROGRAM SOURCE_FOLDER. Needs no display: SDL's offscreen driver and Mesa do. Tests that need
OpenGL are left out, and say so, where the program cannot have it (unless BALLPIT_REQUIRE_GPU=1).
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import resource
except ImportError:   # Windows
    resource = None

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
TIME_LIMIT_S = 120
GOOD_SCENE = {
    "name": "Test", "box": {"half_extent": [2, 2, 2]},
    "laws": {"gravity": [0, 0, -9.8], "contact": {"stiffness": 1000}, "walls": True},
    "balls": [{"position": [0, 0, 0], "radius": 0.1, "mass": 1}],
}


def run(*arguments, folder=None, size_limit=None, powerless=False, **environment):
    def limit_files():
        if size_limit:
            resource.setrlimit(resource.RLIMIT_FSIZE, (size_limit, size_limit))
        if powerless and os.geteuid() == 0:   # root may write everywhere
            os.setgid(65534)
            os.setuid(65534)

    env = {**os.environ, "SDL_VIDEODRIVER": "offscreen", "SDL_AUDIODRIVER": "dummy"}
    for name, value in environment.items():
        env.pop(name, None)
        if value is not None:
            env[name] = value
    return subprocess.run([str(PROGRAM), *map(str, arguments)], capture_output=True, text=True, env=env, cwd=folder,
                          timeout=TIME_LIMIT_S, check=False, preexec_fn=limit_files if size_limit or powerless else None,
                          restore_signals=False)   # SIGXFSZ stays ignored: a write beyond the limit just fails


def has_opengl():
    return run("check", "--scene", "two_balls", "--steps", "1").returncode == 0


class CommandLine(unittest.TestCase):
    opengl = True

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="ballpit-test-")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def need_opengl(self):
        if not self.opengl:
            self.skipTest("no OpenGL 4.3 here")

    def headless(self, *arguments, **environment):
        return run("headless", "--backend", "cpu", *arguments, folder=self.folder, **environment)

    def refused(self, result, code, *parts):
        """Exit code, and one sentence on stderr with all parts; nothing of a crash, nothing on stdout."""
        text = result.stderr
        self.assertEqual(result.returncode, code, text + result.stdout)
        self.assertEqual(len(text.strip().splitlines()), 1, "not one sentence: " + text)
        self.assertTrue(text.startswith("ballpit: "), text)
        self.assertNotIn("exception", text.lower())
        for part in parts:
            self.assertIn(part, text)

    def scene_file(self, name="scene.json", **changes):
        path = self.folder / name
        path.write_text(json.dumps({**GOOD_SCENE, **changes}))
        return path

    def home(self):
        """A copy of what the program reads, to be spoiled."""
        home = self.folder / "home"
        shutil.copytree(SOURCE / "glsl", home / "glsl")
        shutil.copytree(SOURCE / "assets", home / "assets")
        return home

    def expect_files(self, *names):
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), sorted(names))

    # Scenes

    def test_unknown_scene(self):
        self.refused(self.headless("--scene", "snow"), 2, "'snow'", "rain", "two_balls")

    def test_missing_scene_file(self):
        self.refused(self.headless("--scene", "missing.json"), 2, "missing.json")

    def test_folder_for_a_scene(self):
        (self.folder / "folder.json").mkdir()
        self.refused(self.headless("--scene", "folder.json"), 2, "folder.json", "found a folder")

    def test_broken_json(self):
        (self.folder / "broken.json").write_text('{\n  "name": "N",,\n}')
        self.refused(self.headless("--scene", "broken.json"), 2, "broken.json, line 2, column 15: expected JSON")

    def test_no_text_at_all(self):
        (self.folder / "binary.json").write_bytes(bytes(range(256)) * 100)
        self.refused(self.headless("--scene", "binary.json"), 2, "binary.json, line", "expected UTF-8 text")

    def test_unknown_key(self):
        path = self.scene_file(laws={"gravty": [0, 0, -9.8]})
        self.refused(self.headless("--scene", path), 2, "scene.json, /laws: expected no other keys", "'gravty'")

    def test_negative_mass(self):
        path = self.scene_file(balls=[{"position": [0, 0, 0], "radius": 0.1, "mass": -1}])
        self.refused(self.headless("--scene", path), 2, "scene.json, /balls/0/mass: expected a number from", "found -1")

    # Settings

    def test_impossible_settings(self):
        for setting, part in [("drag=-1", "from 0 to 100"), ("drag=fast", "'fast'"), ("dragg=1", "'dragg'"),
                              ("drag", "KEY=VALUE"), ("integrator=euler", "leapfrog"), ("substeps=0", "from 1 to 1024"),
                              ("gravity=1,2", "x,y,z"), ("dt=nan", "'nan'"), ("restitution=7", "from 0.05 to 1")]:
            with self.subTest(setting):
                self.refused(self.headless("--scene", "rain", "--set", setting), 2, part)

    def test_a_setting_of_a_law_that_the_scene_has_not(self):
        self.refused(self.headless("--scene", "elastic_gas", "--set", "gravity=0,0,-1"), 2, "'gravity'", "Elastic gas")

    def test_absurd_counts(self):
        for count in ("4194305", "99999999999999999999", "-1", "1e9", "many"):
            with self.subTest(count):
                self.refused(self.headless("--scene", "rain", "--set", f"balls={count}"), 2, f"'{count}'", "4194304")
        self.refused(self.headless("--scene", "two_balls", "--set", "balls=3"), 2, "lists 2 and has no fill")

    # The command line itself

    def test_what_is_no_option(self):
        self.refused(run("--bogus"), 2, "--bogus")
        self.refused(run("headless", "--steps", "-1"), 2, "--steps")
        self.refused(run("headless", "--steps", "some"), 2, "--steps")
        self.refused(run("headless", "--backend", "abacus"), 2, "abacus")
        self.refused(run("headless", "--seed", "-1"), 2, "--seed")
        self.refused(self.headless("--screenshot", "a.png", "--size", "0x0"), 2, "--size")
        self.refused(self.headless("--screenshot", "a.png", "--size", "wide"), 2, "--size")

    def test_help(self):
        for arguments in (["--help"], ["headless", "--help"], ["--version"]):
            result = run(*arguments)
            self.assertEqual((result.returncode, result.stderr), (0, ""), arguments)
            self.assertTrue(result.stdout.strip())

    def test_lists(self):
        scenes = run("scenes")
        self.assertEqual(scenes.returncode, 0)
        for path in (SOURCE / "assets" / "scenes").glob("*.json"):
            self.assertEqual(path.name != "scene.schema.json", path.stem in scenes.stdout, path.name)
        settings = run("settings")
        self.assertEqual(settings.returncode, 0)
        for key in ("balls", "gravity", "drag", "stiffness", "restitution", "substeps", "dt", "integrator", "sort"):
            self.assertIn(key, settings.stdout)

    def test_ledger(self):
        """The smallest sets of passes and bytes, as the program tells them; a row a scene and what it does without."""
        result = run("scenes", "--ledger", "--json", "ledger.json", folder=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        rows = {row["scene"]: row for row in json.loads((self.folder / "ledger.json").read_text())["rows"]}
        scenes = {path.stem for path in (SOURCE / "assets" / "scenes").glob("*.json")} - {"scene.schema"}
        self.assertEqual(set(rows), scenes)
        lines = result.stdout.splitlines()
        for name, row in rows.items():
            with self.subTest(name):
                place = next(i for i, line in enumerate(lines) if line.split()[:1] == [name])
                self.assertEqual(lines[place].split()[1], str(row["balls"]))
                self.assertEqual(lines[place + 1].strip(), ("without " + ", ".join(row["without"])).strip())
                self.assertEqual(row["constants"] is None, not self.opengl)
        fall = rows["free_fall"]
        self.assertEqual((fall["dispatches"], fall["bytes_per_ball"], fall["sort_dispatches"]), (1, 32, 0))
        self.assertEqual(fall["barriers"], {"before": 1, "within": 0})
        self.assertTrue({"grid", "sort", "walls", "radius", "mass", "drag"} <= set(fall["without"]))
        gas = rows["elastic_gas"]["without"]
        self.assertTrue({"neighbours' velocities", "dashpot", "radius read", "gravity", "drag"} <= set(gas), gas)
        self.assertTrue({"radius read", "mass read", "restitution per ball"} <= set(rows["pile"]["without"]))
        self.assertNotIn("radius read", rows["mixed_sizes"]["without"])
        self.refused(run("scenes", "--json", "-"), 2, "--ledger")

    # Files that are read besides the scene

    def test_missing_shader_folder(self):
        home = self.home()
        shutil.rmtree(home / "glsl")
        self.refused(self.headless("--scene", "rain", BALLPIT_HOME=str(home)), 2, "glsl", str(home))

    def test_missing_shader_file(self):
        self.need_opengl()
        home = self.home()
        (home / "glsl" / "collide.comp").unlink()
        result = run("headless", "--backend", "gpu", "--scene", "two_balls", "--steps", "1", BALLPIT_HOME=str(home))
        self.refused(result, 2, "collide.comp")

    def test_missing_and_broken_model(self):
        self.need_opengl()
        broken = self.folder / "broken.obj"
        broken.write_text("v 0 0\nf 1 2 99\n")
        for model in ("missing.obj", broken.name):
            with self.subTest(model):
                result = self.headless("--scene", "two_balls", "--steps", "1", "--screenshot", "a.png", "--model", model)
                self.refused(result, 2, model)
        self.expect_files("broken.obj")

    # Files that are written

    def test_unwritable_outputs(self):
        (self.folder / "taken").mkdir()
        for option in ("--state-out", "--trace", "--json"):
            for target in ("no/such/folder/out.txt", "taken"):
                with self.subTest(option=option, target=target):
                    result = self.headless("--scene", "two_balls", "--steps", "1", option, target)
                    self.refused(result, 2, target)
        self.expect_files("taken")

    def test_bad_input_leaves_no_files(self):
        outputs = ["--state-out", "s.csv", "--trace", "t.csv", "--json", "r.json"]
        self.refused(self.headless("--scene", "snow", *outputs), 2)
        self.refused(self.headless("--scene", "rain", "--set", "drag=-1", *outputs), 2)
        self.expect_files()

    def test_an_old_output_survives_a_refusal(self):
        (self.folder / "s.csv").write_text("precious")
        self.refused(self.headless("--scene", "snow", "--state-out", "s.csv"), 2)
        self.assertEqual((self.folder / "s.csv").read_text(), "precious")

    @unittest.skipUnless(resource, "no limits to set here")
    def writers(self):
        """Everything that writes a file: name and command line; the file is "out"."""
        few = ("--backend", "cpu", "--scene", "two_balls")
        for option in ("--state-out", "--trace", "--json", "--save"):
            yield option, ("headless", *few, "--steps", "1", option, "out")
        for option in ("--json", "--csv"):
            yield "bench " + option, ("bench", *few, "--steps", "1", option, "out")
            yield "accuracy " + option, ("accuracy", *few, "--seconds", "0.02", "--substeps", "8", "--integrator",
                                         "leapfrog", option, "out")
        for option in ("--json", "--markdown"):
            yield "extremes " + option, ("extremes", "--backend", "cpu", "--only", "E16", option, "out")
        if self.opengl:
            yield "--screenshot", ("headless", *few, "--steps", "1", "--size", "64x64", "--screenshot", "out")

    def test_a_full_disk(self):
        """A limit on the size of files stands in for it: what was there before stays."""
        old = "what was there before, and is longer than the limit"
        for name, command in self.writers():
            for before in (None, old):
                with self.subTest(name, before=before):
                    if before:
                        (self.folder / "out").write_text(before)
                    result = run(*command, folder=self.folder, size_limit=16)
                    self.assertEqual(result.returncode, 2, result.stderr + result.stdout)
                    self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
                    self.assertIn("out", result.stderr)
                    self.expect_files(*(["out"] if before else []))
                    if before:
                        self.assertEqual((self.folder / "out").read_text(), before)
                        (self.folder / "out").unlink()

    def test_a_trace_that_finds_no_room_ends_the_run(self):
        result = self.headless("--scene", "two_balls", "--steps", "100000000", "--trace", "out", size_limit=5000)
        self.refused(result, 2, "out", "to the end")
        self.expect_files()

    @unittest.skipUnless(hasattr(os, "setuid"), "no users here")
    def test_a_folder_that_may_not_be_written(self):
        try:
            reachable = run("scenes", powerless=True).returncode == 0
        except (OSError, subprocess.SubprocessError):
            reachable = False
        if not reachable:
            self.skipTest("only root can read this source tree")
        place = self.folder / "out"
        place.write_text("old")
        place.chmod(0o444)
        self.folder.chmod(0o555)
        self.addCleanup(self.folder.chmod, 0o755)
        for name, command in self.writers():
            with self.subTest(name):
                result = run(*command, folder=self.folder, powerless=True)
                self.refused(result, 2, "out")
                self.assertEqual(place.read_text(), "old")
                self.expect_files("out")

    @unittest.skipUnless(hasattr(os, "mkfifo"), "no pipes in the file system here")
    def test_a_pipe_stays_a_pipe(self):
        """Were it written beside and renamed, a file would take the pipe's (or a device's) place."""
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
        self.addCleanup(os.close, reader)
        result = self.headless("--scene", "two_balls", "--steps", "1", "--state-out", "pipe")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(pipe.is_fifo())
        self.assertTrue(os.read(reader, 1000).startswith(b"id,x,y,z"))

    def test_a_link_stays_a_link(self):
        (self.folder / "target").write_text("old")
        (self.folder / "link").symlink_to("target")
        self.assertEqual(self.headless("--scene", "two_balls", "--steps", "1", "--state-out", "link").returncode, 0)
        self.assertTrue((self.folder / "link").is_symlink())
        self.assertTrue((self.folder / "target").read_text().startswith("id,"))

    def test_outputs(self):
        result = self.headless("--scene", "two_balls", "--steps", "3", "--state-out", "s.csv", "--trace", "t.csv",
                               "--json", "r.json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.expect_files("s.csv", "t.csv", "r.json")
        state = (self.folder / "s.csv").read_text().splitlines()
        self.assertEqual(state[0], "id,x,y,z,vx,vy,vz,radius,mass")
        self.assertEqual(len(state), 3)
        trace = (self.folder / "t.csv").read_text().splitlines()
        self.assertTrue(trace[0].startswith("step,time,kinetic,potential,elastic,momentum_x,momentum_y,momentum_z,"
                                            "max_overlap,contacts,x0,y0,z0,vx0,vy0,vz0,x1"))
        self.assertTrue(trace[0].endswith("vz1,heat_drag,heat_contacts,heat_walls,work,unexplained,angular_momentum_x,"
                                          "angular_momentum_y,angular_momentum_z,mean_overlap,fastest,floor_force,"
                                          "dt_over_dt_c"))
        self.assertEqual({len(row.split(",")) for row in trace}, {10 + 2 * 6 + 12})
        self.assertEqual([row.split(",")[0] for row in trace[1:]], ["0", "1", "2", "3"])
        report = json.loads((self.folder / "r.json").read_text())
        self.assertEqual((report["backend"], report["balls"], report["steps"]), ("cpu", 2, 3))

    def test_meters(self):
        for backend in ("cpu", "auto"):
            common = ("headless", "--scene", "rain", "--set", "balls=300", "--backend", backend, "--steps", "60",
                      "--json", "r.json")
            self.assertEqual(run(*common, folder=self.folder).returncode, 0)
            plain = json.loads((self.folder / "r.json").read_text())
            self.assertNotIn("balance", plain["meters"])
            self.assertEqual(run(*common, "--meters", folder=self.folder).returncode, 0)
            metered = json.loads((self.folder / "r.json").read_text())
            self.assertEqual(metered["state_hash"], plain["state_hash"])
            self.assertEqual(metered["meters"]["reading"], plain["meters"]["reading"])
            balance = metered["meters"]["balance"]
            self.assertGreater(balance["heat_drag_J"], 0.0)
            self.assertGreater(balance["heat_contacts_J"] + balance["heat_walls_J"], 0.0)
            self.assertLess(abs(balance["unexplained_J"]), 0.02 * abs(balance["potential_change_J"]))
            self.assertIn("dt / dt_c", [gauge["name"] for gauge in metered["meters"]["gauges"]])

    def test_json_on_standard_output_is_json_alone(self):
        result = self.headless("--scene", "two_balls", "--steps", "1", "--json", "-")
        self.assertEqual(json.loads(result.stdout)["steps"], 1)

    # The same run every time

    def test_the_same_run_twice_and_another_seed(self):
        for name, seed in (("a.csv", 1), ("b.csv", 1), ("c.csv", 2)):
            result = self.headless("--scene", "rain", "--set", "balls=200", "--steps", "5", "--seed", seed,
                                   "--state-out", name)
            self.assertEqual(result.returncode, 0, result.stderr)
        a, b, c = ((self.folder / name).read_bytes() for name in ("a.csv", "b.csv", "c.csv"))
        self.assertEqual(a, b)
        self.assertNotEqual(a, c)

    def test_no_balls(self):
        result = self.headless("--scene", "rain", "--set", "balls=0", "--steps", "2", "--state-out", "s.csv")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual((self.folder / "s.csv").read_text().splitlines(), ["id,x,y,z,vx,vy,vz,radius,mass"])

    # OpenGL that is missing, old or spoiled

    def test_no_display(self):
        result = run(SDL_VIDEODRIVER="x11", DISPLAY=None, WAYLAND_DISPLAY=None)
        self.refused(result, 3, "no display")

    def test_old_opengl(self):
        self.need_opengl()
        old = {"MESA_GL_VERSION_OVERRIDE": "4.1", "MESA_GLSL_VERSION_OVERRIDE": "410"}
        scene = ["--scene", "two_balls", "--steps", "1"]
        self.refused(run("headless", "--backend", "gpu", *scene, **old), 3, "4.3")
        automatic = run("headless", *scene, "--json", "-", **old)
        self.assertEqual(automatic.returncode, 0, automatic.stderr)
        self.assertEqual(json.loads(automatic.stdout)["backend"], "cpu")
        self.assertIn("CPU mirror", automatic.stderr + automatic.stdout)

    def test_no_opengl_at_all(self):
        nothing = {"SDL_VIDEODRIVER": "dummy"}   # SDL's dummy driver has windows, but no OpenGL
        self.refused(run("headless", "--backend", "gpu", "--scene", "two_balls", "--steps", "1", **nothing), 3)
        self.refused(self.headless("--scene", "two_balls", "--steps", "1", "--screenshot", "a.png", **nothing), 3)
        self.expect_files()
        self.assertEqual(self.headless("--scene", "two_balls", "--steps", "1", **nothing).returncode, 0)

    def test_check_passes_and_fails(self):
        self.need_opengl()
        good = run("check", "--scene", "pile", "--set", "balls=200", "--steps", "2")
        self.assertEqual(good.returncode, 0, good.stdout + good.stderr)
        home = self.home()
        collide = home / "glsl" / "collide.comp"
        text = collide.read_text()
        spoiled = text.replace("params.drift * v;", "1.01 * params.drift * v;")
        self.assertNotEqual(text, spoiled)
        collide.write_text(spoiled)
        bad = run("check", "--scene", "pile", "--set", "balls=200", "--steps", "2", BALLPIT_HOME=str(home))
        self.assertEqual(bad.returncode, 1, bad.stdout + bad.stderr)
        self.assertIn("collide", bad.stdout)

    def test_screenshot(self):
        self.need_opengl()
        result = run("headless", "--scene", "two_balls", "--steps", "1", "--screenshot", "a.png", "--size", "320x200",
                     folder=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        picture = (self.folder / "a.png").read_bytes()
        self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual((int.from_bytes(picture[16:20], "big"), int.from_bytes(picture[20:24], "big")), (320, 200))

    def test_a_budget_chooses_the_substeps(self):
        result = self.headless("--scene", "two_balls", "--budget", "balanced", "--steps", "1", "--json", "-")
        self.assertEqual(result.returncode, 0)
        report = json.loads(result.stdout)
        self.assertTrue(report["budget"]["met"])
        self.assertEqual(report["settings"]["substeps"], str(report["budget"]["substeps"]))
        self.assertIn("budget balanced: 6 substeps with leapfrog", result.stderr)
        self.assertEqual(report["budget"]["critical_dt_from"], "assumption")
        self.refused(self.headless("--scene", "two_balls", "--budget", "cheap"), 2, "--budget", "fast")
        self.refused(self.headless("--scene", "two_balls", "--budget", "fast", "--set", "substeps=3"), 2,
                     "--budget fast", "substeps=3")
        self.refused(run("bench", "--budget", "fast", "--substeps", "4"), 2, "--budget", "--substeps")

    def test_bench(self):
        csv_file = self.folder / "b.csv"
        result = run("bench", "--backend", "cpu", "--balls", "300,600", "--state", "start,settled", "--sort",
                     "bitonic,bitonic_fused", "--steps", "2", "--dispatches", "--json", "-", "--csv", str(csv_file))
        self.assertEqual(result.returncode, 0, result.stderr)
        report = json.loads(result.stdout)
        for key in ("device", "driver", "command", "date"):
            self.assertTrue(report[key])
        self.assertTrue(report["possible"] and report["sorts_agree"])
        self.assertGreater(report["limits"]["copies"][0]["gb_s"], 0)
        self.assertEqual(len(report["rows"]), 8)
        for row in report["rows"]:
            self.assertEqual(row["scene"], "Bench pile")
            self.assertEqual(set(row["stages"]), {"assign_cells", "bitonic_sort", "build_grid", "collide"})
            self.assertEqual("settling" in row, row["state"] == "settled")
            self.assertEqual(row["dispatches"][0]["name"], "assign_cells")
        falling, resting = report["rows"][0], report["rows"][2]
        self.assertEqual(falling["contacts_per_ball"], 0)
        self.assertTrue(resting["settling"]["at_rest"])
        self.assertGreater(resting["contacts_per_ball"], 3)
        self.assertEqual(resting["hash"], report["rows"][3]["hash"])
        self.assertEqual(len(csv_file.read_text().splitlines()), 9)

    def test_bench_refuses(self):
        for arguments, words in ((["--steps", "0"], ["--steps"]), (["--state", "asleep"], ["settled"]),
                                 (["--sort", "bubble"], ["bitonic_fused"]), (["--balls", "9999999"], ["balls"]),
                                 (["--set", "dt=0"], ["dt"]), (["--limit", "0"], ["--limit"]),
                                 (["--scene", "two_balls", "--state", "settled"], ["gravity"])):
            self.refused(run("bench", "--backend", "cpu", *arguments), 2, *words)

    def test_accuracy(self):
        csv_file = self.folder / "a.csv"
        result = run("accuracy", "--backend", "cpu", "--scene", "two_balls", "--integrator", "leapfrog,historical",
                     "--substeps", "4,12", "--precision", "float,compensated", "--json", "-", "--csv", str(csv_file))
        self.assertEqual(result.returncode, 0, result.stderr)
        report = json.loads(result.stdout)
        for key in ("device", "driver", "command", "date", "scene"):
            self.assertTrue(report[key])
        self.assertTrue(report["complete"])
        self.assertEqual(len(report["rows"]), 8)
        errors = {(r["integrator"], r["substeps"], r["precision"]): r["position_error"] for r in report["rows"]}
        self.assertLess(errors["leapfrog", 12, "float"], 1e-3)
        self.assertGreater(errors["historical", 12, "float"], 1e-2)
        for rung in report["collisions"]:
            bound = 0.025 * (rung["expected"] - 1) if rung["integrator"] == "historical" else (
                2.1 / rung["substeps_a_contact"] ** 3 + rung["rounding"])
            self.assertLessEqual(abs(rung["mean"] - rung["expected"]), bound, rung)
        lines = csv_file.read_text().splitlines()
        self.assertEqual(len(lines), 9)
        self.assertTrue(lines[0].startswith("device,driver,backend,command,date,scene"))

    def test_accuracy_refuses(self):
        for arguments in (["--substeps", "0"], ["--integrator", "rk4"], ["--precision", "double"],
                          ["--seconds", "-1"], ["--limit", "0"], ["--scene", "nothing"]):
            result = run("accuracy", "--backend", "cpu", *arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)

    # Extremes

    def test_extremes(self):
        table = self.folder / "extremes.md"
        result = run("extremes", "--backend", "reference", "--only", "E10,E20", "--json", "-", "--markdown", table)
        self.assertEqual(result.returncode, 0, result.stderr)
        report = json.loads(result.stdout)
        for key in ("device", "driver", "command", "date"):
            self.assertTrue(report[key])
        self.assertTrue(report["passed"])
        self.assertEqual([row["id"] for row in report["rows"]], ["E10", "E20"])
        for row in report["rows"]:
            self.assertTrue(row["claims"] and all(claim["holds"] for claim in row["claims"]), row)
        lines = table.read_text().splitlines()
        self.assertIn("reference", lines[1])
        self.assertEqual(sum(line.startswith("| E") for line in lines), 2)

    def test_extremes_refuses(self):
        self.refused(run("extremes", "--backend", "cpu", "--only", "E99"), 2, "E99", "E1")
        self.refused(run("extremes", "--backend", "mirror"), 2, "mirror")


if __name__ == "__main__":
    CommandLine.opengl = has_opengl() or os.environ.get("BALLPIT_REQUIRE_GPU") == "1"
    unittest.main(argv=sys.argv[:1], verbosity=2)
