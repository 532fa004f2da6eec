#!/usr/bin/env bash
# Looks into grid, neighbours and buffers as a person does, with keys and mouse: inspection_window_test.sh BALLPIT
binary=$1
source "$(dirname "$0")/support/window.sh"

field=880x590+20+110         # everything but frame rate and side panel
left=640x180+20+140         # where the windows of cells and of one ball stand at first
table=400x250+480+60        # the table of buffers
pile=300x160+300+500        # balls in the picture, below the windows
legend=200x110+695+600      # bottom right of the picture
grid_counts=280x100+86+602  # under the left one of two pictures

# ---- The test

start_display

cd "$work"   # exports land here
start_app --scene pile --set balls=1500 --set substeps=3 --backend gpu   # fewer are warned of
point 640 4
wait_for "a picture that is not blank" colourful $pile 200
wait_for "a still picture" is_still $field
closed=$(region $field)

# press KEY REGION WHAT: the key changes the region, which then stands still.
press() {
    local before
    before=$(region "$2")
    key "$1"
    wait_for "$3" differs "$2" "$before"
    wait_for "a still region: $3" is_still "$2"
}
# click X Y REGION WHAT: the same for the left button.
click() {
    local before
    point "$1" "$2"
    sleep 0.5   # what lies under the pointer lights up
    before=$(region "$3")
    xdotool click 1
    wait_for "$4" differs "$3" "$before"
    point 640 4
    wait_for "a still region: $4" is_still "$3"
}

step "keys alone follow a ball, and forget it"
press period $left "the ball's way"
first=$(region $left)
press period $left "the next ball"
press comma $left "the ball before"
equals $left "$first" || fail "another ball came back"
press Delete $left "the ball to be forgotten"
press t $left "the window to close"
wait_for "all as it was" equals $field "$closed"

step "a click picks a ball, a click beside it none"
click 440 560 $left "the ball's way"
press Right $left "the next step's numbers"
press Left $left "the numbers of the step before"
click 40 650 $legend "the ball to be forgotten"
press t $left "the window to close"

toggles c $left "the table of cells"
toggles l $pile "the slice"
toggles i $legend "the legend of contacts"
toggles v $legend "the legend of arrows"

step "a row of the table is a cell, and the arrow keys move the layer"
press c $left "the table of cells"
press l $pile "the slice"
press Up $pile "another layer"
click 60 300 $left "the chosen row"
key Delete
press l $legend "the slice to close"
press c $left "the table to close"

step "every buffer is a table"
press u $table "the table"
for slot in velocities damping_ratios keys cell_ranges status next_positions next_velocities compensations; do
    press shift+u $table "the table of $slot"
done
key shift+u   # built_positions are as empty as compensations
sleep 1
press shift+u $table "the table of positions"

step "a buffer is exported"
point 695 52
sleep 0.5
xdotool click 1
wait_for "the file" eval '[ -n "$(ls "$work"/ballpit_step*_positions.csv 2>/dev/null)" ]'
[ "$(wc -l <"$(ls "$work"/ballpit_step*_positions.csv)")" = 1501 ] || fail "the file has not one line a ball"
point 640 4
press Escape $below "the message to close"
press u $table "the table to close"

step "brute force beside the grid, and a smaller cell tests fewer pairs"
press x $pile "two pictures"
point 455 118
counts=$(region $grid_counts)
type_value 0.5
wait_for "other counts" differs $grid_counts "$counts"
point 640 4
press x $pile "one picture"

step "it runs with everything open"
key t c u l i v x period space
wait_for "the picture to move" differs $pile "$(region $pile)"
key space
wait_for "the pause" is_still $clock
key x
kill -0 "$app" || fail "the program has ended"

step "Ctrl+Q quits with exit code 0"
key ctrl+q
expect_exit 0

echo "inspection window test passed"
