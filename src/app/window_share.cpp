#include "app/window_share.h"

#include <SDL.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/atomic_file.h"
#include "app/user_folders.h"
#include "app/window_picture.h"
#include "core/error.h"
#include "core/scene_writer.h"
#include "ui/widgets.h"

namespace ballpit::app {

namespace {

namespace fs = std::filesystem;

constexpr double slice_s = 0.03;         // of a replay, a frame
constexpr std::size_t long_code = 8192;  // letters
constexpr std::size_t longest_stem = 60;

std::string clipboard() {
    const std::unique_ptr<char, decltype(&SDL_free)> text(SDL_GetClipboardText(), &SDL_free);
    return text ? text.get() : "";
}

// A scene's name as a file name, on every system. The step that it was saved at before goes: another one comes.
std::string file_stem(std::string name) {
    const std::size_t dash = name.rfind('-');
    if (dash != std::string::npos && dash + 1 < name.size() &&
        name.find_first_not_of("0123456789", dash + 1) == std::string::npos) {
        name.resize(dash);
    }
    std::string stem;
    for (const char letter : name) {
        const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
        const bool capital = letter >= 'A' && letter <= 'Z';
        if (plain || capital) {
            stem += capital ? static_cast<char>(letter - 'A' + 'a') : letter;
        } else if (!stem.empty() && stem.back() != '_') {
            stem += '_';
        }
    }
    while (!stem.empty() && stem.back() == '_') {
        stem.pop_back();
    }
    return stem.empty() ? "scene" : stem.substr(0, longest_stem);
}

fs::path place_of(const fs::path& folder, const std::string& name) {
    fs::path file = folder / name;
    if (file.extension() != ".json") {
        file += ".json";
    }
    return file;
}

void write(const fs::path& place, const std::string& text) {
    AtomicFile file(place);
    file.stream() << text;
    file.commit();
}

}  // namespace

Shown shown_now(const Seen& seen) { return {seen.view, seen.views.probe_options(), light_options(seen.light)}; }

bool Sharing::act(ui::Action action) {
    switch (action) {
        case ui::Action::share:
            state_.open = !state_.open;
            if (state_.open) {
                open_panel();
            }
            return true;
        case ui::Action::save_scene:
            save();
            return true;
        case ui::Action::paste_code:
            paste();
            return true;
        default:
            return false;
    }
}

void Sharing::act(const ui::CopyCode&) { copy(); }

SharedCode Sharing::code_of_now() {
    SharedCode code;
    session_.describe(code);
    code.shown = shown_now(seen_);
    code.camera = seen_.camera.camera();
    code.ball = seen_.inspection.ball;
    code.cell = seen_.inspection.cell;
    return code;
}

// A code is of a moment, so the run stands still while it is looked at.
void Sharing::open_panel() {
    clock_.pause();
    try {
        state_.code = encode_share_code(code_of_now());
        copy();
    } catch (const InputError& error) {
        state_.code.clear();
        state_.note = error.what();
    }
}

void Sharing::copy() {
    const bool copied = SDL_SetClipboardText(state_.code.c_str()) == 0;
    state_.note =
        copied ? "Copied: " + ui::grouped(state_.code.size()) + " letters." : "The clipboard does not take it.";
    if (copied && state_.code.size() > long_code) {
        state_.note += " That is long for a line: a scene file may travel better.";
    }
}

void Sharing::paste() {
    const std::string text = clipboard();
    if (text.empty()) {
        message_ = "There is nothing in the clipboard: copy a share code first.";
    } else {
        open_code(text);
    }
}

void Sharing::open_code(const std::string& text) {
    SharedCode code;
    try {
        code = decode_share_code(text);
    } catch (const InputError& error) {
        message_ = error.what();
        return;
    }
    if (!session_.open(code)) {
        return;  // it has said why
    }
    clock_.pause();
    state_.open = false;
    sent_ = std::move(code);
    replay_.emplace(sent_.changes, sent_.substep, sent_.ran);
    compared_step_.reset();
    scene_changes_ = session_.scene_changes();
}

void Sharing::open_file(const std::string& file) {
    clock_.pause();
    session_.open_file(fs::path(reinterpret_cast<const char8_t*>(file.c_str())));
}

bool Sharing::close() {
    if (replay_) {
        replay_.reset();
        look_wanted_ = true;
    } else if (state_.open) {
        state_.open = false;
    } else {
        return false;
    }
    return true;
}

// In the folder that the program was started in, or, where nothing can be written there, in the user's own.
void Sharing::save() {
    try {
        const std::string text = scene_text(session_.scene_of_moment());
        fs::path place = place_of(fs::current_path(), state_.file);
        try {
            write(place, text);
        } catch (const InputError&) {
            const fs::path folder = data_folder();
            std::error_code ignored;
            fs::create_directories(folder, ignored);
            if (folder.empty() || fs::exists(place, ignored)) {
                throw;  // there is one of that name, and another elsewhere would be missed
            }
            place = place_of(folder, state_.file);
            write(place, text);
        }
        message_ = "Saved: " + place.string();
    } catch (const InputError& error) {
        message_ = error.what();
    } catch (const std::exception& error) {
        message_ = std::string("The scene cannot be saved: ") + error.what();
    }
}

void Sharing::update() {
    if (std::exchange(look_wanted_, false)) {
        show_as_sent();
    }
    if (replay_) {
        const bool ended = session_.replay(*replay_, slice_s);
        state_.replay = ui::ReplayProgress{session_.simulation().step_count(), replay_->goal().step};
        if (ended) {
            replay_.reset();
            look_wanted_ = true;
            compared_step_ = session_.simulation().step_count();
        }
    }
    if (!replay_) {
        state_.replay.reset();
    }
    const Simulation& simulation = session_.simulation();
    const std::string proposal = file_stem(session_.scene_stem()) + "-" + std::to_string(simulation.step_count());
    if (state_.file == named_) {  // nobody has typed another
        state_.file = proposal;
    }
    named_ = proposal;
    compare();
}

void Sharing::show_as_sent() {
    seen_.view = sent_.shown.view;
    seen_.views.act(ui::ChangeProbe{sent_.shown.probe});
    seen_.light = light_of(sent_.shown.light);
    seen_.inspection.ball = sent_.ball;
    seen_.inspection.cell = sent_.cell;
    if (sent_.camera) {
        seen_.camera.look_from(*sent_.camera);
    }
}

void Sharing::compare() {
    state_.hash_step = session_.simulation().step_count();
    state_.hash = session_.stepper().hash(state_.hash_step);
    state_.match = ui::HashMatch::unknown;
    if (scene_changes_ != session_.scene_changes()) {
        compared_step_.reset();
    }
    if (!state_.hash || !sent_.hash || compared_step_ != state_.hash_step) {
        return;
    }
    const Backend& backend = session_.simulation().backend();
    const bool same_device = sent_.backend == backend.name() && sent_.device == backend.device();
    const bool equal = *state_.hash == *sent_.hash;
    state_.match = equal ? ui::HashMatch::equal : ui::HashMatch::differs;
    if (equal) {
        state_.match_about = "= the code's: the same bits";
    } else if (same_device) {
        state_.match_about = "≠ the code's, though the device has the same name";
    } else {
        state_.match_about =
            "≠ the code's: it ran on " + sent_.backend + ", " + sent_.device + ", where last bits differ";
    }
}

}  // namespace ballpit::app
