#!/usr/bin/env bash
# Uses the window as a person does, on a display that nobody sees: window_test.sh BALLPIT
binary=$1
source "$(dirname "$0")/support/window.sh"

# ---- The test

start_display

step "starts paused, and shows something"
start_app --scene rain --set balls=300 --set substeps=5 --backend gpu   # fewer are warned of, above the timings
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
