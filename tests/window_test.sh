#!/usr/bin/env bash
# Uses the window as a person does, on a display that nobody sees: window_test.sh BALLPIT
# Needs Xvfb, xdotool, ImageMagick and python3; without them it is skipped (77), or fails where CI=true.
# Every wait polls, so that a slow machine needs longer and not other numbers. Places are those of a window of
# 1280 x 720, where the panels have their design size.
set -euo pipefail

binary=$1
work=$(mktemp -d)
patience=90   # s for one thing to happen
app=
display_server=
manager=

cleanup() {
    [ -z "$manager" ] || kill "$manager" 2>/dev/null || true
    [ -z "$app" ] || kill "$app" 2>/dev/null || true
    [ -z "$display_server" ] || kill "$display_server" 2>/dev/null || true
    rm -rf "$work"
}
trap cleanup EXIT

fail() {
    echo "FAILED: $*" >&2
    if [ -n "${BALLPIT_TEST_OUTPUT:-}" ] && [ -n "${window:-}" ]; then
        mkdir -p "$BALLPIT_TEST_OUTPUT"
        import -window "$window" "$BALLPIT_TEST_OUTPUT/window_test.png" || true
        echo "the window as it was: $BALLPIT_TEST_OUTPUT/window_test.png" >&2
    fi
    [ ! -s "$work/log" ] || sed 's/^/  program: /' "$work/log" >&2
    exit 1
}

for tool in Xvfb xdotool import convert identify python3; do
    if ! command -v "$tool" >/dev/null; then
        [ "${CI:-}" = true ] && fail "$tool is missing"
        echo "skipped: $tool is missing"
        exit 77
    fi
done

# wait_for WHAT COMMAND...: until the command succeeds.
wait_for() {
    local what=$1 end=$((SECONDS + patience))
    shift
    until "$@"; do
        [ $SECONDS -lt $end ] || fail "waited $patience s for: $what"
        [ -z "$app" ] || kill -0 "$app" 2>/dev/null || fail "the program ended while waiting for: $what"
        sleep 0.05
    done
}

# ---- Display and program

start_display() {
    # The server picks a free number and writes it when it is ready.
    Xvfb -displayfd 3 -screen 0 1400x900x24 -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
    display_server=$!
    wait_for "the display" test -s "$work/display"
    DISPLAY=:$(cat "$work/display")
    export DISPLAY SDL_VIDEODRIVER=x11
    export LIBGL_ALWAYS_SOFTWARE=1   # the same pictures everywhere
}

has_window() {
    window=$(xdotool search --onlyvisible --name "Ball Pit" 2>/dev/null | tail -n 1)
    [ -n "$window" ]
}

start_app() {
    "$binary" "$@" >"$work/log" 2>&1 &
    app=$!
    wait_for "the window" has_window
    xdotool windowfocus "$window"
    point 640 360
}

# The exit code of the program, which has been asked to close.
expect_exit() {
    local end=$((SECONDS + patience)) code=0
    while kill -0 "$app" 2>/dev/null; do
        [ $SECONDS -lt $end ] || fail "the program does not close"
        sleep 0.05
    done
    wait "$app" || code=$?
    app=
    [ "$code" = "$1" ] || fail "exit code $code instead of $1"
}

# What a window manager does when its close button is pressed.
close_by_window_manager() {
    python3 - "$window" <<'PYTHON'
import ctypes
import sys

class ClientMessage(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong),
                ("format", ctypes.c_int), ("data", ctypes.c_long * 5), ("room", ctypes.c_long * 24)]

x11 = ctypes.CDLL("libX11.so.6")
x11.XOpenDisplay.restype = display_type = ctypes.c_void_p
x11.XInternAtom.restype = ctypes.c_ulong
display = display_type(x11.XOpenDisplay(None))
message = ClientMessage(type=33, window=int(sys.argv[1]), format=32)
message.message_type = x11.XInternAtom(display, b"WM_PROTOCOLS", 0)
message.data[0] = x11.XInternAtom(display, b"WM_DELETE_WINDOW", 0)
x11.XSendEvent(display, ctypes.c_ulong(message.window), 0, ctypes.c_long(0), ctypes.byref(message))
x11.XFlush(display)
PYTHON
}

# ---- What is on screen. A region is WxH+X+Y.

all=1280x720+0+0
middle=420x380+460+310    # of the picture, clear of all panels but the help page
side=340x640+920+20       # the side panel
clock=250x16+14+70        # "t = ... step ... seed ..."
below=400x150+20+120      # under the frame rate: messages, timings
corner=380x160+20+540     # bottom left: occupancy
tick=20x20+1095+547       # the check box of the occupancy panel

shot() { import -window "$window" "$work/shot.png"; }
region() { shot; convert "$work/shot.png" -crop "$1" +repage rgb:- | cksum; }
colours() { shot; convert "$work/shot.png" -crop "$1" +repage -format %k info:; }

differs() { [ "$(region "$1")" != "$2" ]; }    # differs REGION SUM
equals() { [ "$(region "$1")" = "$2" ]; }
is_still() {
    local before
    before=$(region "$1")
    sleep 0.3
    equals "$1" "$before"
}
colourful() { [ "$(colours "$1")" -gt "$2" ]; }
titled() { case $(xdotool getwindowname "$window") in $1) ;; *) return 1 ;; esac; }   # a shell pattern
sized() { [ "$(identify -format %wx%h "$work/shot.png")" = "$1" ]; }
shot_sized() { shot && sized "$1"; }

point() { xdotool mousemove --window "$window" "$1" "$2"; }
drag() {   # drag FROM_X FROM_Y TO_X TO_Y, in three moves, so that no frame sees it all at once
    point "$1" "$2"
    xdotool mousedown 1
    point $((($1 + $3) / 2)) $((($2 + $4) / 2))
    point "$3" "$4"
    sleep 0.2
    xdotool mouseup 1
}
type_value() {   # into the slider under the pointer
    xdotool keydown Control_L
    sleep 0.5
    xdotool click 1
    sleep 0.5
    xdotool keyup Control_L
    xdotool type --delay 60 -- "$1"
    key Return
}
key() { xdotool key --delay 30 "$@"; }
step() { echo "- $*"; }

# toggles KEY REGION NAME: the key changes the region, and once more brings it back.
toggles() {
    local before
    step "$3 comes and goes with $1"
    wait_for "a still $3" is_still "$2"
    before=$(region "$2")
    key "$1"
    wait_for "$3 to come" differs "$2" "$before"
    key "$1"
    wait_for "$3 to go" equals "$2" "$before"
}

# ---- The test

start_display

step "starts paused, and shows something"
start_app --scene rain --set balls=300 --set substeps=2 --backend gpu
wait_for "the title" titled "Rain - 300 balls - Ball Pit"
wait_for "a picture that is not blank" colourful $middle 500
wait_for "panels that are not blank" colourful $side 50
wait_for "a still picture" is_still $middle
start_picture=$(region $middle)
start_clock=$(region $clock)
sleep 1
equals $middle "$start_picture" || fail "the picture moves though nobody pressed Run"

step "one step with Enter, and no more"
key Return
wait_for "the step" differs $clock "$start_clock"
wait_for "a still clock" is_still $clock
one_step=$(region $clock)

step "runs with Space, pauses with P"
key space
wait_for "the picture to move" differs $middle "$start_picture"
moving=$(region $middle)
wait_for "the picture to move on" differs $middle "$moving"
key p
wait_for "the pause" is_still $middle
paused=$(region $middle)
sleep 1
equals $middle "$paused" || fail "the picture moves on after the pause"

step "restarts with R at the same seed, with Shift+R at another"
key r
wait_for "the restart" equals $clock "$start_clock"
key o
wait_for "the same first step" equals $clock "$one_step"
key shift+r
wait_for "another seed on screen" differs $clock "$one_step"
differs $clock "$start_clock" || fail "Shift+R kept the seed"

step "a slider moves with the mouse, and the ball count with it"
drag 1099 186 1060 186
wait_for "another ball count in the title" eval '! titled "Rain - 300 balls*"'
titled "Rain - * balls - Ball Pit" || fail "the title is '$(xdotool getwindowname "$window")'"

step "a value is typed after Ctrl+click, and letters in it are no keys"
before=$(region $tick)
point 1060 186
type_value 1g2p3
wait_for "the typed ball count" titled "Rain - 123 balls*"
equals $tick "$before" || fail "G opened the occupancy panel while a field had the keyboard"
type_value -5
wait_for "the clamped ball count" titled "Rain - 0 balls*"
type_value 300
wait_for "the ball count of the start" titled "Rain - 300 balls*"
point 640 360

toggles g $corner "the occupancy panel"
toggles F3 $below "the timings panel"
toggles F1 $middle "the help page"
toggles Tab $side "the side panel"

step "Esc closes the help page, and never the program"
before=$(region $middle)
key F1
wait_for "the help page" differs $middle "$before"
key Escape
wait_for "the help page to close" equals $middle "$before"
key Escape
key Escape

step "the mouse turns the camera, Home brings it back"
before=$(region $middle)
drag 640 360 740 400
wait_for "another view" differs $middle "$before"
turned=$(region $middle)
xdotool click 4
wait_for "a nearer view" differs $middle "$turned"
xdotool keydown w
sleep 0.3
xdotool keyup w
key Home
wait_for "the first view again" equals $middle "$before"

step "the brackets go through the scenes"
key bracketright
wait_for "another scene" eval '! titled "Rain*"'
key bracketleft
wait_for "the scene of the start" titled "Rain - 5000 balls*"

step "the window can be resized"
xdotool windowsize --sync "$window" 900 600
wait_for "the new size" shot_sized 900x600
wait_for "a picture of the new size" colourful 900x600+0+0 500
xdotool windowsize --sync "$window" 1280 720
wait_for "the old size" shot_sized 1280x720

if command -v openbox >/dev/null; then
    step "full screen and back"
    openbox >/dev/null 2>&1 &   # it is the window manager that makes a window fill the screen
    manager=$!
    wait_for "the window manager" eval 'xdotool get_num_desktops >/dev/null 2>&1'
    xdotool windowactivate --sync "$window"
    key F11
    wait_for "full screen" shot_sized 1400x900
    key Escape
    wait_for "the window again" shot_sized 1280x720
else
    step "full screen: skipped, for want of a window manager (openbox)"
fi

step "Ctrl+Q quits with exit code 0"
xdotool windowfocus "$window"
key ctrl+q
expect_exit 0

step "without OpenGL 4.3 the mirror computes, and the window says so"
MESA_GL_VERSION_OVERRIDE=4.1 start_app --scene rain --set balls=200
wait_for "the title" titled "Rain - 200 balls*"
wait_for "a picture that is not blank" colourful $all 500
wait_for "the message" is_still $below
before=$(region $below)
key Escape
wait_for "the message to go" differs $below "$before"
wait_for "a still picture" is_still $middle
before=$(region $middle)
key space
wait_for "the picture to move" differs $middle "$before"

step "closing the window quits with exit code 0"
close_by_window_manager
expect_exit 0

step "an explicit --backend gpu without OpenGL 4.3 is refused with exit code 3"
code=0
MESA_GL_VERSION_OVERRIDE=4.1 "$binary" --backend gpu >"$work/log" 2>&1 || code=$?
[ "$code" = 3 ] || fail "exit code $code instead of 3"
grep -q "OpenGL 4.3" "$work/log" || fail "the refusal does not name OpenGL 4.3"

echo "window test passed"
