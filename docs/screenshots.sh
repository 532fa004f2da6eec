#!/usr/bin/env bash
# Takes the pictures of the views for the documentation from the running program: docs/screenshots.sh BALLPIT [NAME...]
# Needs Xvfb, xdotool and ImageMagick. Without names: all. Every picture starts the program anew, so that each
# stands for itself; keys do what F1 says they do.
set -euo pipefail

binary=$(realpath "$1")
export XDG_CONFIG_HOME=$(mktemp -d)   # no settings of whoever takes the pictures
shift
here=$(cd "$(dirname "$0")" && pwd)
images=$here/images
work=$(mktemp -d)
app=

stop_app() {
    [ -z "$app" ] || kill "$app" 2>/dev/null || true
    [ -z "$app" ] || wait "$app" 2>/dev/null || true
    app=
}
cleanup() {
    stop_app
    [ -z "${display_server:-}" ] || kill "$display_server" 2>/dev/null || true
    rm -rf "$work"
}
trap cleanup EXIT

for tool in Xvfb xdotool import convert; do
    command -v "$tool" >/dev/null || { echo "$tool is missing" >&2; exit 1; }
done
Xvfb -displayfd 3 -screen 0 1280x720x24 -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
display_server=$!
until [ -s "$work/display" ]; do sleep 0.1; done
DISPLAY=:$(cat "$work/display")
export DISPLAY SDL_VIDEODRIVER=x11

# ---- What a picture is made of

open() {   # open ARGUMENTS...: the program, with its window
    "$binary" "$@" >/dev/null 2>&1 &
    app=$!
    until window=$(xdotool search --onlyvisible --name "Ball Pit" 2>/dev/null | tail -n 1) && [ -n "$window" ]; do
        sleep 0.1
    done
    xdotool windowfocus "$window"
    point 640 4
    settle
}
key() { for name in "$@"; do xdotool key --delay 40 "$name"; sleep 0.1; done; }
times() {   # times COUNT KEY
    local i
    for ((i = 0; i < $1; ++i)); do key "$2"; done
}
point() {   # where there is no hand, only a button makes the place of the pointer known; the right one does nothing here
    xdotool mousemove --window "$window" "$1" "$2"
    sleep 0.2
    xdotool click 3
    sleep 0.2
}
click() {
    point "$1" "$2"
    sleep 0.4
    xdotool click 1
}
sum() { import -window "$window" rgb:- | cksum; }
settle() {   # until four looks are the same; what blinks never settles
    local before='' now same=0 tries
    for ((tries = 0; tries < 40 && same < 3; ++tries)); do
        now=$(sum)
        [ "$now" = "$before" ] && same=$((same + 1)) || same=0
        before=$now
        sleep 0.7
    done
}
take() {   # take NAME
    settle
    import -window "$window" "$work/shot.png"
    convert "$work/shot.png" -dither None -colors 256 -define png:compression-level=9 PNG8:"$images/$1.png"
    echo "$images/$1.png"
    stop_app
}
# A copy of the shaders and assets with one line changed: planted FILE RIGHT WRONG.
planted() {
    rm -rf "$work/home"
    mkdir "$work/home"
    cp -r "$here/../glsl" "$here/../assets" "$work/home/"
    grep -qF "$2" "$work/home/glsl/$1" || { echo "$1 has no $2" >&2; exit 1; }
    python3 - "$work/home/glsl/$1" "$2" "$3" <<'PYTHON'
import pathlib
import sys

file, right, wrong = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
file.write_text(file.read_text().replace(right, wrong, 1))
PYTHON
}

# ---- The pictures

stepping_strip() {   # the seventeenth pass of a sort, stage by stage checked
    open --scene rain
    key 4; times 3 Right
    key 3; times 2 Right
    key k
    key 1; times 18 Right
    take stepping_strip
}

stepping_microscope() {   # sixteen slots, one of them explained
    open --scene rain
    key m 1; times 14 Right
    settle
    point 207 349
    take stepping_microscope
}

stepping_microscope_64() {   # a pass whose partners lie far apart, and padding
    open --scene rain --set balls=100
    key m shift+m 1; times 24 Right
    take stepping_microscope_64
}

stepping_microscope_all() {   # all keys, half of the way through
    open --scene rain
    key m shift+m shift+m 1; times 58 Right
    take stepping_microscope_all
}

stepping_slot_to_ball() {   # a click on a slot, and the camera is there
    open --scene rain
    key m 1; times 7 Right
    click 640 349
    sleep 5
    point 640 4
    take stepping_slot_to_ball
}

stepping_check() {   # a student's bug: the grid's origin added instead of subtracted
    planted shared/cells.glsl '(point - params.grid_origin)' '(point + params.grid_origin)'
    BALLPIT_HOME=$work/home open --scene rain
    key 4 Right
    settle
    key k
    settle
    key j
    take stepping_check
}

settled_pile() { open --scene pile --set balls=1500 --set substeps=4; key 4; times 60 Right; settle; }

inspection_follow() {   # a ball in a pile, in the middle of a substep's life: all of it has run
    settled_pile
    key t
    click 450 560
    point 640 4
    take inspection_follow
}

inspection_cells() {   # the cells, and the third layer as a heat map
    open --scene rain --set substeps=4
    key 4; times 60 Right
    key c l Up Up
    point 545 572
    xdotool keydown Control_L; sleep 0.5; xdotool click 1; sleep 0.5; xdotool keyup Control_L
    point 640 4
    take inspection_cells
}

inspection_contacts() {   # who carries whom: the largest forces in a pile are near its floor
    settled_pile
    key i
    take inspection_contacts
}

inspection_slots() {   # what the sort did: neighbours in memory have like colours
    settled_pile
    times 4 shift+v
    take inspection_slots
}

inspection_buffers() {   # the keys, sorted half of the way
    open --scene rain
    key 4 Right Right 1; times 40 Right
    key u shift+u shift+u shift+u
    take inspection_buffers
}

inspection_split() {   # cells of half a diameter, and what they miss
    settled_pile
    key x
    point 455 122
    xdotool keydown Control_L; sleep 0.5; xdotool click 1; sleep 0.5; xdotool keyup Control_L
    xdotool type --delay 60 0.8
    key Return
    times 2 Right
    point 640 4
    take inspection_split
}

playing_laws() {   # what each law of a pile costs; measuring takes its time where a CPU draws
    open --fresh --scene pile --set balls=2000
    key 4; times 40 Right
    key F4
    point 640 4
    sleep 60
    take playing_laws
}

accuracy_budget() {   # what a pile with few substeps gets wrong, and the count that would do
    open --fresh --scene pile --set balls=300
    key F7
    sleep 12
    point 640 4
    take accuracy_budget
}

accuracy_explorer() {   # what a hundred choices cost and how exact they are
    open --fresh --scene two_balls --backend cpu
    key F8
    point 100 133; xdotool click 1   # Measure this scene
    sleep 100
    point 60 156; xdotool click 1    # Position
    point 640 4
    take accuracy_explorer
}

playing_hand() {   # a string of balls, and one of them on its way to the hand
    open --fresh --scene two_balls
    point 440 330
    times 5 b
    key h
    xdotool mousemove --window "$window" 452 345; sleep 0.3
    xdotool mousedown 1; sleep 0.3
    xdotool mousemove --window "$window" 560 250; sleep 0.5
    times 6 o
    take playing_hand
    xdotool mouseup 1
}

all="stepping_strip stepping_microscope stepping_microscope_64 stepping_microscope_all stepping_slot_to_ball
    stepping_check inspection_follow inspection_cells inspection_contacts inspection_slots inspection_buffers
    inspection_split playing_laws playing_hand accuracy_budget
    accuracy_explorer"

for picture in ${*:-$all}; do
    "$picture"
done
