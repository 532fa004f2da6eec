"""A folder of src/ includes only what stands to its right (docs/architecture.md), and gl/ nothing of ours.

Usage: layering_test.py SOURCE_FOLDER. The checker is first tried on planted faults: a check that cannot fail is none.
"""
import pathlib
import re
import sys

# Folder -> folders that it may include besides itself.
ALLOWED = {
    "core": set(),
    "measure": {"core"},
    "gl": set(),
    "cpu": {"measure", "core"},
    "gpu": {"gl", "measure", "core"},
    "view": {"gl", "measure", "core"},
    "ui": {"measure", "core"},
    "app": {"ui", "view", "gpu", "cpu", "measure", "core", "gl"},
}
# Third-party headers that belong to one folder alone.
OWNED = {
    "glad/gl.h": {"gl", "gpu", "view", "app"},
    "SDL.h": {"gl", "app"},
    "imgui": {"ui", "app"},
    "tiny_obj_loader.h": {"view"},
    "stb_": {"view", "app"},
    "nlohmann": {"core", "app"},
    "CLI": {"app"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]', re.MULTILINE)


def faults_of(folder, name, text):
    """Sentences about the includes of one file of src/<folder>."""
    for included in INCLUDE.findall(text):
        first = included.split("/")[0]
        if first in ALLOWED and first != folder and first not in ALLOWED[folder]:
            yield f"src/{folder}/{name} includes {included}: {folder} may not look into {first}"
        if included.startswith("..") or "/../" in included:
            yield f"src/{folder}/{name} includes {included}: write \"folder/file.h\""
        for prefix, owners in OWNED.items():
            if included.startswith(prefix) and folder not in owners:
                yield f"src/{folder}/{name} includes {included}: only {', '.join(sorted(owners))} may"


def faults_of_tree(source):
    count = 0
    for path in sorted((source / "src").rglob("*")):
        if path.suffix not in {".h", ".cpp"} or path.parent == source / "src":
            continue
        folder = path.relative_to(source / "src").parts[0]
        if folder not in ALLOWED:
            yield f"src/{folder} has no place in the order of the folders"
            continue
        count += 1
        yield from faults_of(folder, path.name, path.read_text(encoding="utf-8"))
    if count < 20:
        yield f"only {count} files found below {source / 'src'}: is this the source folder?"


def self_test():
    planted = [
        ("core", '#include "gl/buffer.h"'),
        ("gl", '#include "core/error.h"'),
        ("ui", '  #  include "gpu/gpu_backend.h"'),
        ("cpu", '#include "gpu/programs.h"'),
        ("measure", '#include "cpu/collide.h"'),
        ("view", '#include "../core/scene.h"'),
        ("core", "#include <SDL.h>"),
    ]
    missed = [text for folder, text in planted if not list(faults_of(folder, "planted.h", text))]
    allowed = [("app", '#include "gl/context.h"'), ("cpu", '#include "core/layout.h"'), ("core", "#include <vector>")]
    wrong = [text for folder, text in allowed if list(faults_of(folder, "planted.h", text))]
    return [f"the checker misses {text}" for text in missed] + [f"the checker refuses {text}" for text in wrong]


def main():
    faults = self_test() + list(faults_of_tree(pathlib.Path(sys.argv[1])))
    print("\n".join(faults) or "every include respects the order of the folders")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
