#!/usr/bin/env python3
"""Makes docs/images/*.svg. With --check: exit 1 if a picture there is not the one that would be made."""

import sys
from pathlib import Path

sys.dont_write_bytecode = True   # leaves the source tree as it is

import accuracy
import physics
import pile_limit
import project
import stages

IMAGES = Path(__file__).resolve().parents[1] / "images"
FIGURES = {**stages.FIGURES, **physics.FIGURES, **project.FIGURES, **accuracy.FIGURES, **pile_limit.FIGURES}


def main():
    check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not check:
        sys.exit("usage: make.py [--check]")
    stale = []
    for name, figure in FIGURES.items():
        file, made = IMAGES / f"{name}.svg", figure()
        if not check:
            file.write_text(made, encoding="utf-8", newline="\n")
        elif not file.is_file() or file.read_text(encoding="utf-8") != made:
            stale.append(file.name)
    if stale:
        sys.exit(f"docs/figures/make.py --check: not what the script makes: {', '.join(stale)} (run docs/figures/make.py)")
    print(f"{len(FIGURES)} figures {'match' if check else 'written to ' + str(IMAGES)}")


if __name__ == "__main__":
    main()
