"""Schema, documentation, `ballpit settings` and parser of scene files say the same.

Usage: scene_schema_test.py PROGRAM SOURCE_FOLDER. From the schema it makes some hundred scene files, at every limit and
just beyond, with every key missing, of another type or unknown; the program must take what the schema takes.
"""
import concurrent.futures
import copy
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import schema_checker as checker

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
SCENES = SOURCE / "assets" / "scenes"
SCHEMA = json.loads((SCENES / "scene.schema.json").read_text(encoding="utf-8"))

MAXIMUM_BALLS = SCHEMA["properties"]["balls"]["maxItems"]

ORIGIN = [0, 0, 0]
SPRING = {"stiffness": 1000, "restitution": 0.9, "limit_force": True, "dashpot": "semi_implicit"}
BALL = {"position": ORIGIN, "velocity": ORIGIN, "radius": 0.1, "mass": 1, "restitution": 0.5, "compensation": [0, 0, 0, 0, 0, 0],
        "quarantined": False}
EVERYTHING = {
    "$schema": "./scene.schema.json", "name": "N", "about": "A.",
    "box": {"half_extent": [1, 1, 1], "reference_count": 5, "walls_low": ORIGIN, "walls_high": ORIGIN, "wall_speed": 1},
    "laws": {"gravity": ORIGIN, "drag": 0.1, "contact": SPRING, "walls": True,
             "shake": {"amplitude": ORIGIN, "frequency": 1}, "diagnostics": True, "compensated": True},
    "time": {"dt": 0.01, "substeps": 2, "integrator": "leapfrog"},
    "compute": {"sort": "bitonic", "cell_factor": 1, "grid_reuse": 1, "neighbours": "grid", "sorted_copies": True,
                "keep_order": True},
    "balls": [BALL],
    "fill": {"count": 2, "radius": [0.1, 0.1], "density": 1, "speed": 1, "region": [ORIGIN, ORIGIN], "seed": 1},
    "bounds": {"speed": 1, "overlap": 1, "outside": 1},
}
MOMENT = {"step": 1, "substep": 1, "time": 1, "velocity_lag": 0, "walls_low": ORIGIN, "walls_high": ORIGIN, "shake_offset": ORIGIN,
          "shake_phase": 0}


def base_scenes():
    """Valid scenes that between them have every key in each of the ways in which keys depend on each other, and the
    places at which to change each."""
    walls_alone = copy.deepcopy(EVERYTHING)
    del walls_alone["laws"]["contact"]
    walls_alone["laws"]["walls"] = SPRING
    resumed = {**EVERYTHING, "resume": MOMENT}
    without_sums = {key: value for key, value in BALL.items() if key != "compensation"}
    bare = {"name": "N", "box": {"half_extent": [1, 1, 1]}, "fill": EVERYTHING["fill"]}
    return [(EVERYTHING, [()]), (walls_alone, [("laws",)]), (resumed, [("resume",), ("balls", 0)]),
            ({**bare, "balls": [without_sums]}, [("balls", 0)]),
            ({**bare, "laws": {"contact": SPRING, "compensated": False}, "balls": [BALL]}, [("balls", 0), ("laws",)]), (bare, [("fill",), ("laws",)])]


# ---- What the schema says of a place

def meanings(schema, value):
    """All parts of the schema that speak of this value: it, behind references, and inside alternatives."""
    schema = checker.resolve(SCHEMA, schema)
    if isinstance(schema, bool):
        return
    yield schema
    for key in ("allOf", "anyOf"):
        for part in schema.get(key, ()):
            yield from meanings(part, value)
    for key in ("then", "else"):
        if key in schema:
            yield from meanings(schema[key], value)


def places(schemas, value, path=()):
    """(path, value, schemas) of every value inside, itself first. Of a list the first and the last element will do."""
    schemas = [meaning for schema in schemas for meaning in meanings(schema, value)]
    yield path, value, schemas
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from places([s["properties"][key] for s in schemas if key in s.get("properties", {})], inner,
                              path + (key,))
    elif isinstance(value, list):
        for index in sorted({0, len(value) - 1} if value else ()):
            yield from places([s["items"] for s in schemas if "items" in s], value[index], path + (index,))


def next_to(limit):
    """The limit and its neighbours, in the limit's own kind of number."""
    if isinstance(limit, int) and abs(limit) > 1000:
        return [limit - 1, limit, limit + 1]
    return [math.nextafter(limit, -math.inf), limit, math.nextafter(limit, math.inf), limit - 1, limit + 1]


def replacements(value, schemas):
    """What to put in a value's place."""
    yield from (None, True, "text", [], {}, -1, 0, 0.5, 2)
    for schema in schemas:
        for limit in ("minimum", "maximum"):
            if limit in schema:
                yield from next_to(schema[limit])
        yield from schema.get("enum", ())
    if isinstance(value, bool):
        yield not value
    elif isinstance(value, str):
        yield ""
    elif isinstance(value, list):
        yield from (value[:-1], value + value[:1])
    elif isinstance(value, dict):
        yield {**value, "unknown": 1}
        for key in value:
            yield {other: inner for other, inner in value.items() if other != key}


def with_value(scene, path, value):
    if not path:
        return value
    changed = copy.copy(scene)
    changed[path[0]] = with_value(scene[path[0]], path[1:], value)
    return changed


def fits_together(scene):
    """What no schema can say: places in the box, the smaller before the larger, and all balls together."""
    half = scene["box"]["half_extent"]
    points = [] if "resume" in scene else [ball["position"] for ball in scene.get("balls", ())]
    fill = scene.get("fill")
    if fill:
        lower, upper = fill.get("region", [half, half])
        points += [lower, upper]
        if any(low > high for low, high in zip([fill["radius"][0], *lower], [fill["radius"][1], *upper])):
            return False
        if fill["count"] + len(scene.get("balls", ())) > MAXIMUM_BALLS:
            return False
    return all(abs(x) <= limit for point in points for x, limit in zip(point, half))


def instances():
    """(what was changed, scene) for every replacement at every place."""
    seen = set()
    for scene, prefixes in base_scenes():
        for path, value, schemas in places([SCHEMA], scene):
            if not any(path[:len(prefix)] == prefix for prefix in prefixes):
                continue
            for replacement in [value, *replacements(value, schemas)]:
                changed = with_value(scene, path, replacement)
                if json.dumps(changed) not in seen:
                    seen.add(json.dumps(changed))
                    yield f"/{'/'.join(map(str, path))} = {json.dumps(replacement)[:80]}", changed


# ---- What the program says

def run(*arguments):
    return subprocess.run([str(PROGRAM), *map(str, arguments)], capture_output=True, text=True, timeout=120,
                          env={**os.environ, "SDL_VIDEODRIVER": "offscreen"}, check=False)


def verdict(folder, number, scene):
    """Whether the program takes the scene; a sentence where it does something else than taking or refusing it."""
    file = pathlib.Path(folder) / f"{number}.json"
    file.write_text(json.dumps(scene), encoding="utf-8")
    # The largest counts are more than a test may ask of a machine; one ball is enough.
    result = run("headless", "--backend", "cpu", "--steps", 0, "--scene", file, "--set", "balls=1")
    lines = result.stderr.strip().splitlines()
    if result.returncode == 0 and not lines:
        return True
    if result.returncode == 2 and len(lines) == 1 and lines[0].startswith(f"ballpit: {file}"):
        return False
    return f"exit code {result.returncode}: {result.stderr}{result.stdout}"


def listed_settings():
    """key -> (unit, line of range and default) of `ballpit settings`."""
    lines = run("settings").stdout.splitlines()
    heads = [re.fullmatch(r"(\w+)(?: \((.*)\))?", line) for line in lines[::3]]
    return {head[1]: (head[2] or "", line.strip()) for head, line in zip(heads, lines[2::3])}


# ---- What the documentation says

def number_text(number):
    return str(number) if isinstance(number, int) else re.sub(r"e\+?(-?)0*", r"e\1", f"{number:g}")


def value_text(value):
    if isinstance(value, str):
        return f"`{value}`"
    if isinstance(value, list):
        return f"[{', '.join(map(value_text, value))}]"
    return json.dumps(value) if isinstance(value, bool) else number_text(value)


def range_text(schema):
    """The range of a key as its table in the documentation has it."""
    if "$ref" in schema:
        return "an object"
    if "enum" in schema:
        return ", ".join(map(value_text, schema["enum"]))
    if "anyOf" in schema:
        return " or ".join(map(range_text, schema["anyOf"]))
    if schema["type"] == "boolean":
        return "true or false"
    if schema["type"] == "string":
        return "text, not empty" if "minLength" in schema else "text"
    if schema["type"] == "array":
        several = f"{schema['minItems']} × ({range_text(schema['items'])})" if "minItems" in schema else None
        return several or f"list of at most {schema['maxItems']}"
    if "minimum" not in schema:
        return "number"
    whole = ", whole" if schema["type"] == "integer" else ""
    return f"{number_text(schema['minimum'])} to {number_text(schema['maximum'])}{whole}"


def documented_tables():
    """Heading -> {key: (unit, range, default)} of docs/scenes.md."""
    tables, heading = {}, None
    for line in (SOURCE / "docs" / "scenes.md").read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            heading = line.strip("#` ")
        row = re.match(r"\| `([\w$]+)` \| ([^|]*) \| ([^|]*) \| ([^|]*) \| ", line)
        if row and heading != "The scenes that ship":
            unit = row[2].strip().replace("²", "^2").replace("³", "^3")
            tables.setdefault(heading, {})[row[1]] = (unit, row[3].strip(), row[4].strip())
    return tables


def objects_of_schema():
    """Heading of the documentation -> the object that it describes."""
    names = {"ball": "balls"}
    return {"The file": SCHEMA, **{names.get(name, name): schema for name, schema in SCHEMA["$defs"].items()}}


class SceneSchema(unittest.TestCase):
    def test_the_checker_knows_every_keyword_of_the_schema(self):
        self.assertEqual(checker.unknown_keywords(SCHEMA), set())

    def test_the_checker_can_fail(self):
        for schema, bad in [({"type": "integer"}, 1.5), ({"type": "number"}, True), ({"const": True}, 1),
                            ({"enum": ["a"]}, "b"), ({"minimum": 1}, 0.999), ({"maximum": 1}, 1.001),
                            ({"minItems": 2}, [1]), ({"maxItems": 1}, [1, 2]), ({"minLength": 1}, ""),
                            ({"items": {"type": "null"}}, [None, 0]), ({"required": ["a"]}, {}),
                            ({"additionalProperties": False}, {"a": 1}), ({"properties": {"a": False}}, {"a": 1}),
                            ({"not": {}}, 1), ({"anyOf": [{"type": "null"}, False]}, 1), ({"allOf": [True, False]}, 1),
                            ({"if": {"type": "null"}, "then": False}, None), ({"if": False, "else": False}, 1),
                            ({"$ref": "#/$defs/none"}, 1)]:
            with self.subTest(schema=schema):
                self.assertFalse(checker.valid({"$defs": {"none": False}}, schema, bad))

    def test_scenes_that_ship(self):
        for file in sorted(SCENES.glob("*.json")):
            scene = json.loads(file.read_text(encoding="utf-8"))
            if file.name != "scene.schema.json":
                with self.subTest(file.name):
                    self.assertTrue(checker.valid(SCHEMA, SCHEMA, scene))
                    self.assertEqual(scene["$schema"], "./scene.schema.json")
                    self.assertTrue(scene["about"].endswith("."))
                    self.assertIn("bounds", scene)

    def test_documentation(self):
        tables = documented_tables()
        self.assertEqual(set(tables), set(objects_of_schema()))
        for heading, schema in objects_of_schema().items():
            self.assertEqual(list(tables[heading]), list(schema["properties"]), heading)
            for key, (unit, values, default) in tables[heading].items():
                node = schema["properties"][key]
                with self.subTest(f"{heading}: {key}"):
                    self.assertEqual(unit, node.get("unit", ""))
                    expected = range_text(node)
                    self.assertTrue(values == expected or values.startswith(expected + ", "), (values, expected))
                    if key in schema.get("required", ()):
                        self.assertEqual(default, "required")
                    elif "default" in node:
                        self.assertEqual(default, value_text(node["default"]))
                    else:
                        self.assertNotIn(default, ("", "required"))

    def test_settings(self):
        settings = listed_settings()
        self.assertIn("stiffness", settings)
        used = set()
        for heading, schema in objects_of_schema().items():
            for key, node in schema["properties"].items():
                if "setting" not in node:
                    continue
                with self.subTest(f"{heading}: {key}"):
                    unit, line = settings[node["setting"]]
                    used.add(node["setting"])
                    self.assertEqual(unit, node.get("unit", ""))
                    values, default = line.split("; default ")
                    limits = node.get("items", node)
                    if "minimum" in limits:
                        low, high = re.fullmatch(r"from (\S+) to (\S+)", values).groups()
                        self.assertEqual((float(low), float(high)), (limits["minimum"], limits["maximum"]))
                    if "enum" in node:
                        self.assertEqual(values, "one of " + " ".join(node["enum"]))
                    if "default" in node:
                        as_text = json.dumps(node["default"]).strip('[]"').replace(" ", "")
                        self.assertEqual(default, as_text)
        # What a scene says in another way: how many balls there are, which laws it has, and that nobody holds a ball.
        self.assertEqual(set(settings) - used, {"balls", "laws", "pull"})

    def test_every_key_is_tried(self):
        tried = {path for scene, _ in base_scenes() for path, _, _ in places([SCHEMA], scene)}
        keys = {key for schema in objects_of_schema().values() for key in schema["properties"]}
        self.assertEqual(keys, {part for path in tried for part in path if isinstance(part, str)})

    def test_the_program_takes_what_the_schema_takes(self):
        made = list(instances())
        self.assertGreater(len(made), 500)
        with tempfile.TemporaryDirectory(prefix="ballpit-test-") as folder:
            with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
                found = list(pool.map(lambda item: verdict(folder, item[0], item[1][1]), enumerate(made)))
        taken = 0
        for (change, scene), said in zip(made, found):
            expected = checker.valid(SCHEMA, SCHEMA, scene) and fits_together(scene)
            taken += expected
            with self.subTest(change):
                self.assertEqual(said, expected)
        self.assertGreater(taken, 100)

    def test_whole_numbers(self):
        """JSON Schema cannot tell 2.0 from 2; the program wants 2."""
        self.assertTrue(checker.valid(SCHEMA, {"type": "integer"}, 2.0))
        with tempfile.TemporaryDirectory(prefix="ballpit-test-") as folder:
            self.assertIs(verdict(folder, 0, with_value(EVERYTHING, ("fill", "count"), 2.0)), False)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
