#include "ui/strip_layout.h"

#include <algorithm>

namespace ballpit::ui {

std::vector<StripBlock> substep_blocks(std::uint32_t substeps, std::uint32_t shown, float width, float narrowest) {
    const auto most = std::max(1u, static_cast<std::uint32_t>(width / narrowest));
    const std::uint32_t count = std::min(substeps, most);
    const std::uint32_t before = std::min(shown, count / 2);
    const std::uint32_t first = std::min(shown - before, substeps - count);
    const float step = width / static_cast<float>(std::max(count, 1u));
    std::vector<StripBlock> blocks;
    for (std::uint32_t i = 0; i < count; ++i) {
        blocks.push_back({first + i, step * static_cast<float>(i), step * static_cast<float>(i + 1)});
    }
    return blocks;
}

std::vector<StripChip> stage_chips(const Schedule& schedule, float width, float gap) {
    std::vector<StripChip> chips;
    const auto count = static_cast<std::uint32_t>(schedule.dispatches.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        const Stage stage = schedule.dispatches[i].stage;
        if (chips.empty() || chips.back().stage != stage) {
            chips.push_back({stage, i, i, 0.0f, 0.0f});
        }
        chips.back().last = i + 1;
    }
    constexpr float shared_equally = 0.7f;
    const auto chip_count = static_cast<float>(chips.size());
    const float room = width - gap * (chip_count - 1.0f);
    float x = 0.0f;
    for (StripChip& chip : chips) {
        const float share = static_cast<float>(chip.last - chip.first) / static_cast<float>(count);
        chip.left = x;
        chip.right = x + room * (shared_equally / chip_count + (1.0f - shared_equally) * share);
        x = chip.right + gap;
    }
    return chips;
}

StripMark mark_of(const StripChip& chip, std::uint32_t dispatch) {
    const float step = (chip.right - chip.left) / static_cast<float>(chip.last - chip.first);
    const auto index = static_cast<float>(dispatch - chip.first);
    return {chip.left + step * index, chip.left + step * (index + 1.0f)};
}

std::optional<std::uint32_t> dispatch_at(const StripChip& chip, float x) {
    if (x < chip.left || x >= chip.right) {
        return std::nullopt;
    }
    const float step = (chip.right - chip.left) / static_cast<float>(chip.last - chip.first);
    return std::min(chip.first + static_cast<std::uint32_t>((x - chip.left) / step), chip.last - 1);
}

}  // namespace ballpit::ui
