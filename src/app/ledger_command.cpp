// `ballpit scenes --ledger`: what each scene of the gallery costs, and what it does without.
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <sstream>

#include "app/commands.h"
#include "app/gallery.h"
#include "app/paths.h"
#include "app/report.h"
#include "core/ledger.h"
#include "core/scene_file.h"
#include "core/scene_schedule.h"
#include "core/text.h"
#include "gl/context.h"
#include "gl/error.h"
#include "gpu/programs.h"

namespace ballpit::app {

namespace {

struct Row {
    std::string name;
    Settings settings;
    Schedule schedule;
};

// Counts the constants of compiled programs; knows none where there is no OpenGL 4.3.
class Constants {
public:
    explicit Constants(const std::filesystem::path& shaders) {
        try {
            gl::ContextOptions options;
            options.visible = false;
            context_ = std::make_unique<gl::Context>(options);
        } catch (const gl::Error&) {
            return;
        }
        if (context_->has_compute()) {
            programs_ = std::make_unique<gpu::Programs>(shaders);
        }
    }

    bool known() const { return programs_ != nullptr; }

    /// Of all programs of a substep together.
    std::optional<std::size_t> count(const Schedule& schedule) {
        if (!known()) {
            return std::nullopt;
        }
        std::set<Program> seen;
        std::size_t sum = 0;
        for (const Dispatch& dispatch : schedule.dispatches) {
            if (seen.insert(dispatch.program).second) {
                sum += programs_->get(dispatch.program).params.count();
            }
        }
        return sum;
    }

private:
    std::unique_ptr<gl::Context> context_;
    std::unique_ptr<gpu::Programs> programs_;
};

std::string barrier_text(const BarrierCount& count) {
    return std::to_string(count.before) + "+" + std::to_string(count.within);
}

std::string five_digits(double value) {
    std::ostringstream out;
    out << std::setprecision(5) << value;
    return out.str();
}

void print_header(std::ostream& out) {
    out << std::left << std::setw(20) << "scene" << std::right << std::setw(9) << "balls" << std::setw(8) << "B/ball"
        << std::setw(11) << "cells KiB" << std::setw(12) << "dispatches" << std::setw(8) << "of sort" << std::setw(10)
        << "barriers" << std::setw(7) << "slots" << std::setw(11) << "constants"
        << "  laws\n";
}

void print(std::ostream& out, const Row& row, std::optional<std::size_t> constants) {
    const Schedule& schedule = row.schedule;
    const std::size_t cells = bytes_of(schedule)[static_cast<std::size_t>(Slot::cell_ranges)];
    out << std::left << std::setw(20) << row.name << std::right << std::setw(9) << schedule.ball_count << std::setw(8)
        << five_digits(bytes_per_ball(schedule)) << std::setw(11) << (cells + 1023) / 1024 << std::setw(12)
        << schedule.dispatches.size() << std::setw(8) << dispatches_of(schedule, Stage::bitonic_sort) << std::setw(10)
        << barrier_text(count_barriers(schedule)) << std::setw(7) << bound_slots(schedule).size() << std::setw(11)
        << (constants ? std::to_string(*constants) : "?") << "  " << laws_text(row.settings.laws) << "\n"
        << "    without " << joined(absences(schedule)) << "\n";
}

Json row_json(const Row& row, std::optional<std::size_t> constants) {
    const Schedule& schedule = row.schedule;
    const auto bytes = bytes_of(schedule);
    Json slots = Json::object();
    for (const Slot slot : bound_slots(schedule)) {
        slots[std::string(slot_name(slot))] = bytes[static_cast<std::size_t>(slot)];
    }
    const BarrierCount barriers = count_barriers(schedule);
    return {{"scene", row.name},
            {"balls", schedule.ball_count},
            {"laws", laws_text(row.settings.laws)},
            {"bytes_per_ball", bytes_per_ball(schedule)},
            {"slots", slots},
            {"dispatches", schedule.dispatches.size()},
            {"sort_dispatches", dispatches_of(schedule, Stage::bitonic_sort)},
            {"barriers", {{"before", barriers.before}, {"within", barriers.within}}},
            {"constants", constants ? Json(*constants) : Json(nullptr)},
            {"without", absences(schedule)}};
}

}  // namespace

int run_ledger(const Options& options) {
    const Paths paths = find_paths();
    Report json(options.json);
    Constants constants(paths.shaders);
    const bool quiet = options.json == "-";
    Json report;
    report["rows"] = Json::array();
    if (!quiet) {
        print_header(std::cout);
    }
    for (const SceneEntry& entry : list_scenes(paths.assets)) {
        const Scene scene = load_scene(entry.path);
        const Row row{entry.name, scene.settings, first_schedule(scene)};
        const auto count = constants.count(row.schedule);
        report["rows"].push_back(row_json(row, count));
        if (!quiet) {
            print(std::cout, row, count);
        }
    }
    if (!quiet) {
        std::cout << "\nAll for one substep. B/ball: without the cell table and the status word. Barriers: before the "
                     "first dispatch + between dispatches.\nConstants: of all programs together"
                  << (constants.known() ? ".\n" : "; ? because there is no OpenGL 4.3 here.\n");
    }
    json.write(report.dump(2) + "\n");
    return 0;
}

}  // namespace ballpit::app
