#!/usr/bin/env bash
# Plays with a scene as a person does: laws ticked, balls thrown, walls dragged: play_window_test.sh BALLPIT
binary=$1
source "$(dirname "$0")/support/window.sh"

count=120x16+14+54          # "... balls" under the frame rate
hint=300x16+14+88           # the hand, below the clock
laws=500x400+20+160         # the window of the laws

play() {   # play BACKEND
    start_app --scene pile --set balls=100 --set substeps=2 --set laws=contact,restitution,walls,diagnostics --backend "$1"
    wait_for "a picture that is not blank" colourful $middle 300
    wait_for "a still picture" is_still $middle

    step "$1: the laws come and go with F4"
    before=$(region $laws)
    key F4
    wait_for "the laws" differs $laws "$before"
    key F4
    wait_for "the picture again" equals $laws "$before"

    step "$1: B shoots a ball, N adds a cluster, and an arrow back takes them away"
    key Return
    wait_for "a still clock" is_still $clock
    start_clock=$(region $clock)
    point 440 380
    key b
    wait_for "101 balls" titled "* 101 balls*"
    key n
    wait_for "a cluster" titled "* 151 balls*"
    key Right
    wait_for "the next step" differs $clock "$start_clock"
    key Left
    key Left
    wait_for "the balls of the start" titled "* 100 balls*"

    step "$1: R restarts without what was thrown"
    key b
    wait_for "101 balls" titled "* 101 balls*"
    key r
    wait_for "100 balls" titled "* 100 balls*"

    step "$1: Z shakes the box"
    wait_for "a still picture" is_still $middle
    before=$(region $middle)
    key z
    key space
    wait_for "the picture to move" differs $middle "$before"
    key space
    wait_for "the pause" is_still $middle

    step "$1: H is told, and a wall is dragged"
    key r
    before=$(region $hint)
    key h
    wait_for "the hand's line" differs $hint "$before"
    wait_for "a still picture" is_still $middle
    before=$(region $middle)
    drag 300 330 420 360
    key o
    wait_for "the wall to move" differs $middle "$before"
    key h

    key ctrl+q
    expect_exit 0
}

# ---- The test

start_display
play gpu
play cpu

echo "play window test passed"
