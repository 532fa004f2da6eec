#include "ui/microscope.h"

#include <algorithm>

#include "measure/sort_pass.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

std::string key_text(const Key& key) {
    return key.cell_id == SENTINEL ? "padding" : "cell " + grouped(key.cell_id) + ", ball " + grouped(key.ball_id);
}

}  // namespace

std::optional<ShownPass> shown_pass(const SteppingState& stepping) {
    const std::uint32_t ran = stepping.place.ran;
    if (ran == 0 || ran > stepping.schedule->dispatches.size()) {
        return std::nullopt;
    }
    const Dispatch& dispatch = stepping.schedule->dispatches[ran - 1];
    if (dispatch.stage != Stage::bitonic_sort) {
        return std::nullopt;
    }
    return ShownPass{dispatch.constants[0], dispatch.constants[1]};
}

SlotWindow slot_window(std::uint32_t key_count, std::uint32_t wanted, std::uint32_t first, std::uint32_t j) {
    SlotWindow window;
    const auto add = [&](std::uint32_t from, std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            window.slots.push_back(from + i);
        }
    };
    if (key_count <= wanted) {
        add(0, key_count);
        return window;
    }
    const std::uint32_t within = std::min(first, key_count - 1);
    if (j < wanted) {
        add(within / wanted * wanted, wanted);
        return window;
    }
    const std::uint32_t half = wanted / 2;
    const std::uint32_t low = (within / half * half) & ~j;
    add(low, half);
    add(low ^ j, half);
    window.split = half;
    return window;
}

std::string slot_story(std::uint32_t slot, const std::optional<ShownPass>& pass, std::span<const Key> keys,
                       std::span<const Key> before) {
    std::string story = "Slot " + grouped(slot) + ": " + key_text(keys[slot]);
    if (!pass || before.size() != keys.size()) {
        return story;
    }
    const measure::CompareExchange pair = measure::compare_exchange_of(slot, pass->k, pass->j, before);
    story += "\nThread " + grouped(pair.thread) + " compares it with slot " + grouped(slot) + " XOR " +
             grouped(pass->j) + " = " + grouped(slot ^ pass->j) + ".";
    story += "\n" + std::string(pair.ascending ? "Ascending" : "Descending") + ": bit k = " + grouped(pass->k) +
             " of slot " + grouped(pair.lower) + (pair.ascending ? " is 0" : " is 1") +
             ", so the larger key belongs to slot " + grouped(pair.ascending ? pair.upper : pair.lower) + ".";
    story += pair.swapped ? "\nSwapped: before, it held " + key_text(before[slot]) + "."
                          : "\nNot swapped: they were in order.";
    return story;
}

}  // namespace ballpit::ui
