// `ballpit scenes` and `ballpit settings`: what there is.
#include <iomanip>
#include <iostream>

#include "app/commands.h"
#include "app/gallery.h"
#include "app/paths.h"
#include "core/scene_file.h"
#include "core/settings.h"

namespace ballpit::app {

int run_scenes() {
    for (const SceneEntry& entry : list_scenes(find_paths().assets)) {
        const Scene scene = load_scene(entry.path);
        std::cout << std::left << std::setw(20) << entry.name << std::right << std::setw(9) << scene.settings.balls
                  << " balls  " << scene.name << ": " << scene.about << "\n";
    }
    return 0;
}

int run_settings() {
    const Settings defaults;
    for (const SettingInfo& info : setting_table()) {
        std::cout << info.key;
        if (!info.unit.empty()) {
            std::cout << " (" << info.unit << ")";
        }
        std::cout << "\n    " << info.about << "\n    ";
        if (const auto choices = setting_choices(info); !choices.empty()) {
            std::cout << "one of";
            for (const std::string_view choice : choices) {
                std::cout << " " << choice;
            }
        } else if (std::holds_alternative<bool Settings::*>(info.member)) {
            std::cout << "true or false";
        } else {
            std::cout << "from " << info.minimum << " to " << info.maximum;
        }
        std::cout << "; default " << (info.key == "balls" ? "as the scene says" : setting_text(info, defaults)) << "\n";
    }
    return 0;
}

}  // namespace ballpit::app
