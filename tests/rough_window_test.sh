#!/usr/bin/env bash
# What is done to a window besides using it: a pixel small, minimised, hidden, moved about. The driver prints every GL error; there must be none: rough_window_test.sh BALLPIT
binary=$1
source "$(dirname "$0")/support/window.sh"
export MESA_DEBUG=1   # else Mesa tells nobody
patience=60

# s of the processor that the program has used, all threads together
processor_time() { awk -v ticks="$(getconf CLK_TCK)" '{ print ($14 + $15) / ticks }' "/proc/$app/stat"; }
rests() {   # at most a fifth of one core, for two seconds
    local before
    before=$(processor_time)
    sleep 2
    awk -v before="$before" -v now="$(processor_time)" 'BEGIN { exit !(now - before < 0.4) }'
}
no_complaints() { ! grep -i "mesa.*error\|assert\|NaN" "$work/log" || fail "$1: the driver complains"; }

start_display -screen 0 2800x900x24   # room for two displays side by side: Xvfb itself lays several over each other

step "sizes down to one pixel, while it runs"
start_app --scene rain --set balls=200 --set substeps=5 --backend gpu
wait_for "a picture that is not blank" colourful $middle 500
key space
for size in "900 1" "1 600" "1 1" "2 2" "300 200"; do
    # shellcheck disable=SC2086  # two numbers
    xdotool windowsize "$window" $size
    sleep 0.7
    kill -0 "$app" || fail "it ended at $size"
done
xdotool windowsize --sync "$window" 1280 720
wait_for "the old size" shot_sized 1280x720
wait_for "the picture" colourful $middle 500
moving=$(region $middle)
wait_for "the picture to move on" differs $middle "$moving"
no_complaints "resized"

step "with every panel open, too"
for panel in g t c F3 F4 F6 F7 F8; do key $panel; done
for size in "1 1" "60 40" "1280 720"; do
    # shellcheck disable=SC2086
    xdotool windowsize "$window" $size
    sleep 1.5
    kill -0 "$app" || fail "it ended at $size"
done
wait_for "the old size" shot_sized 1280x720
no_complaints "resized with panels"

step "hidden, it rests though it runs; seen again, it goes on"
xdotool windowunmap --sync "$window"
wait_for "rest" rests
xdotool windowmap --sync "$window"
wait_for "the picture" colourful $middle 500
moving=$(region $middle)
wait_for "the picture to move on" differs $middle "$moving"

step "where a second display would be, and half out of sight, it runs the same"
xdotool windowmove --sync "$window" 1410 20
wait_for "the picture" colourful $middle 500
moving=$(region $middle)
wait_for "the picture to move on" differs $middle "$moving"
xdotool windowmove --sync "$window" 2400 700
sleep 0.5
kill -0 "$app" || fail "it ended half out of sight"
xdotool windowmove --sync "$window" 10 10

if command -v openbox >/dev/null; then
    step "minimised, it rests"
    openbox >/dev/null 2>&1 &
    manager=$!
    wait_for "the window manager" eval 'xdotool get_num_desktops >/dev/null 2>&1'
    xdotool windowactivate --sync "$window"
    xdotool windowminimize "$window"
    wait_for "rest" rests
    xdotool windowactivate --sync "$window"
    wait_for "the picture" colourful $middle 500
    moving=$(region $middle)
    wait_for "the picture to move on" differs $middle "$moving"
else
    step "minimised: skipped, for want of a window manager (openbox)"
fi
no_complaints "moved, hidden, minimised"

step "Ctrl+Q quits with exit code 0"
xdotool windowfocus "$window"
key ctrl+q
expect_exit 0
no_complaints "at the end"

echo "rough window test passed"
