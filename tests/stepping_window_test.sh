#!/usr/bin/env bash
# Looks inside a step with nothing but the keyboard, as with a clicker in class: stepping_window_test.sh BALLPIT
binary=$1
source "$(dirname "$0")/support/window.sh"

strip=870x150+20+555        # the strip, without the check
hash=150x16+66+682          # of the state
scope=870x300+20+210        # the microscope above it
where=330x16+20+555         # "Step ..., substep ..., dispatch ..."

# press KEY REGION WHAT: the key changes the region, which then stands still.
press() {
    local before
    before=$(region "$2")
    key "$1"
    wait_for "$3" differs "$2" "$before"
    wait_for "a still region: $3" is_still "$2"
}
# back_and_forth COUNT FORTH BACK: after as many of one as of the other all is as it was.
back_and_forth() {
    local before i
    wait_for "a still strip" is_still $strip
    before=$(region $strip)
    for ((i = 0; i < $1; ++i)); do
        press "$2" $where "place $i on the way there"
    done
    for ((i = 0; i < $1; ++i)); do
        press "$3" $where "place $i on the way back"
    done
    wait_for "the strip as it was after $1 times $2 and $3" equals $strip "$before"
}

# ---- The test

start_display

start_app --scene rain --set balls=300 --set substeps=2 --backend gpu
wait_for "a picture that is not blank" colourful $middle 500
wait_for "a still picture" is_still $middle
start_clock=$(region $clock)

step "an arrow steps forth and back by whole steps, as does a clicker"
press Right $clock "the first step"
one=$(region $clock)
press Next $clock "the second step"
press Prior $clock "the first step again"
equals $clock "$one" || fail "PgUp does not lead back"
press Left $clock "the start"
equals $clock "$start_clock" || fail "the start is not the start"

step "the strip comes with F2, and by itself with a smaller unit"
press F2 $strip "the strip"
press F2 $strip "no strip"
press 2 $strip "the strip for stages"

step "stages, passes, substeps and steps lead forth and back"
back_and_forth 3 Right Left
key 1
back_and_forth 4 Next Prior
key 3
back_and_forth 3 Right Left
key 1
press Right $where "into the substep"
press shift+Right $where "a stage, the next larger unit"
press shift+Left $where "a stage back"
press ctrl+End $where "the end of the step"
press ctrl+Home $where "the start of the step"

step "the way back over many steps ends on the same hash"
key 4
press Right $hash "another hash"
there=$(region $hash)
for i in 1 2 3 4; do press Right $hash "step $i"; done
differs $hash "$there" || fail "the hash does not change"
for i in 1 2 3 4; do press Left $where "step $i back"; done
wait_for "the hash of the first time" equals $hash "$there"

step "stepping pauses a run"
key space
wait_for "the picture to move" differs $clock "$(region $clock)"
key Left
wait_for "the pause" is_still $clock
sleep 1
is_still $clock || fail "it runs on"

step "the microscope comes with M, shows other sizes, and follows the passes"
press m $scope "the microscope"
press shift+m $scope "sixty-four slots"
press shift+m $scope "all slots"
press shift+m $scope "sixteen slots"
key 1
press Right $scope "the keys without an order"
press Right $scope "the first pass"
press Right $scope "the second pass"
press m $scope "the picture again"

step "the check shows badges, and J goes through the stages until it closes"
press k $strip "the badges"
for stage in assign_cells bitonic_sort build_grid collide none; do
    press j $scope "the differences of $stage"
done
press k $strip "no badges"

step "with the panels hidden the strip goes across the window"
press Tab 300x100+940+560 "the wider strip"
press Tab 300x100+940+560 "the side panel"

step "all of it on the CPU mirror"
key ctrl+q
expect_exit 0
start_app --scene rain --set balls=300 --set substeps=2 --backend cpu
wait_for "a picture that is not blank" colourful $middle 500
press 1 $strip "the strip"
press k $strip "the badges"
key k
back_and_forth 3 Right Left
key ctrl+q
expect_exit 0

echo "stepping window test passed"
