#include "app/probe_work.h"

#include <algorithm>
#include <chrono>

#include "core/stopwatch.h"

namespace ballpit::app {

namespace {

void measure_overlaps(const measure::BufferSample& sample, ProbeWork& work) {
    std::vector<float> overlaps;
    for (const measure::Pair& pair : work.pairs.found) {
        overlaps.push_back(measure::overlap_of(sample.positions[pair.a], sample.positions[pair.b]));
    }
    if (!overlaps.empty()) {
        const auto usual = overlaps.begin() + static_cast<std::ptrdiff_t>(overlaps.size() * 9 / 10);
        std::ranges::nth_element(overlaps, usual);
        work.usual_overlap = *usual;
        work.largest_overlap = *std::max_element(usual, overlaps.end());
    }
}

}  // namespace

ProbeWork work_out(const measure::BufferSample& sample, const ProbeWants& wants) {
    const auto start = std::chrono::steady_clock::now();
    ProbeWork work;
    work.wants = wants;
    if (wants.pairs || wants.value == BallValue::contacts) {
        work.pairs = measure::found_pairs(sample);
        measure_overlaps(sample, work);
    }
    if (wants.cells) {
        work.cells = measure::ordered_cells(sample.grid, sample.cell_ranges, wants.order);
    }
    switch (wants.value) {
        case BallValue::none:
            break;
        case BallValue::slot:
            work.values = measure::slot_values(sample);
            break;
        case BallValue::contacts:
            work.values = measure::contact_values(work.pairs, sample.positions.size());
            break;
        case BallValue::radius:
            work.values = measure::radius_values(sample);
            break;
    }
    work.ms = milliseconds_since(start);
    return work;
}

}  // namespace ballpit::app
