#!/usr/bin/env bash
# Keeping and sharing as a person does it: share_window_test.sh BALLPIT
binary=$(realpath "$1")
source "$(dirname "$0")/support/window.sh"

corner=300x24+10+684    # the state hash
mark=300x20+10+668      # above it, what a code makes of it
view=420x400+460+270    # of the picture, clear of panels

clipboard() {   # what the program has copied, by way of the library that it uses itself
    timeout 20 python3 - <<'PYTHON'
import ctypes
import ctypes.util
sdl = ctypes.CDLL(ctypes.util.find_library("SDL2-2.0") or "libSDL2-2.0.so.0")
sdl.SDL_GetClipboardText.restype = ctypes.c_char_p
sdl.SDL_Init(0x20)
print(sdl.SDL_GetClipboardText().decode())
PYTHON
}
has_code() {
    code=$(clipboard)
    case $code in ballpit1.*) ;; *) return 1 ;; esac
}
settles() {   # settles WHAT: the picture stands still
    wait_for "$1" is_still $view
    wait_for "$1: a still hash" is_still $corner
}
closes() {
    key ctrl+q
    expect_exit 0
}
config="$XDG_CONFIG_HOME/ballpit"

start_display
cd "$work"

step "F copies a code of the moment"
start_app --scene mixed_sizes --set balls=150 --set substeps=2 --backend gpu
settles "the start"
for unit in o o Right; do
    before=$(region $corner)
    key $unit
    wait_for "a step" differs $corner "$before"
    settles "the step"
done
drag 500 300 560 320
point 640 360
settles "another view"
picture=$(region $view)
key f
wait_for "the panel" differs $view "$picture"
wait_for "a code in the clipboard" has_code
key Escape
wait_for "the panel to close" equals $view "$picture"

step "Ctrl+S saves a scene file"
key ctrl+s
wait_for "the file" test -s "$work/mixed_sizes-3.json"
closes
[ -s "$config/settings.json" ] || fail "nothing was remembered"

step "--code shows the same frame, and says that the bits agree"
start_app --code "$code" --backend gpu
wait_for "the same picture" equals $view "$picture"
wait_for "the mark" colourful $mark 20
closes
env SDL_VIDEODRIVER=offscreen "$binary" headless --backend gpu --code "$code" --screenshot "$work/there.png" >"$work/shared"
grep -q "agrees: the same bits" "$work/shared" || fail "headless does not agree: $(cat "$work/shared")"

step "a code that is cut off is one sentence"
! "$binary" headless --code "${code%????}" 2>"$work/log" || fail "it was accepted"
grep -q "cut off or damaged" "$work/log" || fail "the refusal does not say why: $(cat "$work/log")"
! "$binary" --code "${code%????}" 2>"$work/log" || fail "the window opened with it"

step "the saved scene has the same bits, and opens in the window"
state_hash() { sed -n 's/.*state hash \([0-9a-f]\{16\}\)$/\1/p' "$1" | head -n 1; }
env SDL_VIDEODRIVER=offscreen "$binary" headless --backend gpu --scene "$work/mixed_sizes-3.json" --steps 0 >"$work/saved"
[ -n "$(state_hash "$work/saved")" ] && [ "$(state_hash "$work/saved")" = "$(state_hash "$work/shared")" ] ||
    fail "other bits: $(cat "$work/saved" "$work/shared")"
start_app --scene "$work/mixed_sizes-3.json" --backend gpu
settles "the saved scene"
closes

step "the window comes back as it was left"
start_app --scene pile --set balls=120 --backend gpu
settles "the start"
key Tab
xdotool windowsize --sync "$window" 1000 600
wait_for "the new size" shot_sized 1000x600
sleep 1
closes
remembering=yes
start_app
wait_for "the scene of last time" titled "Pile - 120 balls*"
wait_for "the size of last time" shot_sized 1000x600
closes

step "--fresh forgets, and the command line counts more"
start_app --scene two_balls
wait_for "the scene that was asked for" titled "Two balls*"
closes
start_app --fresh
wait_for "the usual scene" titled "Rain*"
closes

step "a damaged settings file is set aside and told of"
printf '{"program": "ballpit", "speed": ' >"$config/settings.json"
start_app
wait_for "the usual scene" titled "Rain*"
wait_for "the file out of the way" test -s "$config/settings.json.bad-1"
wait_for "the sentence" colourful $below 20
closes

step "a folder that cannot be written is no reason to stop"
rm -rf "$XDG_CONFIG_HOME"
: >"$XDG_CONFIG_HOME"
start_app --scene two_balls
settles "the start"
closes

echo "share window test passed"
