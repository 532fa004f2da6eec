// The light that orbits above the balls.
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

bool slider(const char* label, const char* about, float& value, float low, float high, const char* pattern) {
    ImGui::PushID(label);
    row_label(label, about);
    const bool changed = ImGui::SliderFloat("##value", &value, low, high, pattern, ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopID();
    return changed;
}

}  // namespace

void light_panel(const State& state, Commands& commands) {
    if (!section("Light", false)) {
        return;
    }
    LightOptions light = state.light;
    bool changed = false;
    row_label("Orbit", "The light goes round while the balls move, and stands still while they do.");
    changed |= ImGui::Checkbox("##orbit", &light.orbiting);
    ImGui::PushID("angle");
    row_label("Angle", "Where on its circle the light stands.");
    changed |= ImGui::SliderAngle("##value", &light.angle, 0.0f, 360.0f, "%.0f°", ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopID();
    changed |= slider("Distance", "Radius of the circle, of the box's half width.", light.distance, 0.0f, 3.0f, "%.2f");
    changed |=
        slider("Height", "Above the box's centre, of its largest half extent.", light.height, -1.0f, 4.0f, "%.2f");
    changed |= slider("Speed", "Of the orbit.", light.speed, -3.0f, 3.0f, "%.2f rad/s");
    changed |= slider("Brightness", "", light.brightness, 0.0f, 4.0f, "%.2f");
    changed |= slider("Ambient", "Light from everywhere, so that no side is black.", light.ambient, 0.0f, 1.0f, "%.2f");
    row_label("Colour", "");
    changed |= ImGui::ColorEdit3("##colour", &light.colour.x);
    if (changed) {
        commands.push_back(ChangeLight{light});
    }
}

}  // namespace ballpit::ui
