# What the window tests share, to be sourced with $binary set: a display that nobody sees, a program on it, keys, mouse
# and looks at what is on screen.
# Needs Xvfb, xdotool, ImageMagick and python3; without them the test is skipped (77), or fails where CI=true.
# Every wait polls, so that a slow machine needs longer and not other numbers. Places are those of a window of
# 1280 x 720, where the panels have their design size.
set -euo pipefail

work=$(mktemp -d)
export XDG_CONFIG_HOME="$work/config" XDG_DATA_HOME="$work/data"   # never the settings of who runs the tests
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
        import -window "$window" "$BALLPIT_TEST_OUTPUT/$(basename "$0" .sh).png" || true
        echo "the window as it was: $BALLPIT_TEST_OUTPUT/$(basename "$0" .sh).png" >&2
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

start_display() {   # start_display SCREENS...: one, without any
    [ $# -gt 0 ] || set -- -screen 0 1400x900x24
    # The server picks a free number and writes it when it is ready. When its last window goes it would start anew, and
    # refuse whoever comes meanwhile.
    Xvfb -noreset -displayfd 3 "$@" -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
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
    [ -n "${remembering:-}" ] || rm -rf "$XDG_CONFIG_HOME"   # else each start is a first one
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
tick=20x20+915+526        # the check box of the occupancy panel

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
