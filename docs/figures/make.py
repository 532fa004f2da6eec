#!/usr/bin/env python3
"""Makes docs/images/*.svg and the tables of docs/performance.md. With --check: exit 1 if something there is not what
would be made."""

import sys
from pathlib import Path

sys.dont_write_bytecode = True   # leaves the source tree as it is

import accuracy
import performance
import physics
import pile_limit
import project
import stages

IMAGES = Path(__file__).resolve().parents[1] / "images"
FIGURES = {**stages.FIGURES, **physics.FIGURES, **project.FIGURES, **accuracy.FIGURES, **pile_limit.FIGURES,
           **performance.FIGURES}


def main():
    check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not check:
        sys.exit("usage: make.py [--check]")
    stale = []
    texts = {IMAGES / f"{name}.svg": figure for name, figure in FIGURES.items()} | {performance.PAGE: performance.page}
    for file, make in texts.items():
        made = make()
        if not check:
            file.write_text(made, encoding="utf-8", newline="\n")
        elif not file.is_file() or file.read_text(encoding="utf-8") != made:
            stale.append(file.name)
    if stale:
        sys.exit(f"docs/figures/make.py --check: not what the script makes: {', '.join(stale)} (run docs/figures/make.py)")
    print(f"{len(FIGURES)} figures and {performance.PAGE.name} {'match' if check else 'written'}")


if __name__ == "__main__":
    main()
