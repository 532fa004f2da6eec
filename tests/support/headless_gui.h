// The panels without a window: frames are laid out, clicks are made up, and nothing is drawn.
#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <string>

#include "ui/panels.h"
#include "ui/style.h"

namespace ballpit::test {

class HeadlessGui {
public:
    explicit HeadlessGui(const ImVec2& size = ImVec2(1280.0f, 720.0f)) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = size;
        io.IniFilename = nullptr;
#if IMGUI_VERSION_NUM >= 19200
        io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
#else
        unsigned char* pixels = nullptr;
        int width = 0;
        int height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);  // a frame needs the glyphs' sizes
#endif
        ui::apply_style(1.0f);
    }
    ~HeadlessGui() { ImGui::DestroyContext(); }
    HeadlessGui(const HeadlessGui&) = delete;
    HeadlessGui& operator=(const HeadlessGui&) = delete;

    ui::Commands frame(const ui::State& state) {
        ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
        ImGui::NewFrame();
        ui::Commands commands;
        ui::draw_panels(state, commands);
        ImGui::Render();
        return commands;
    }

    /// What is asked for by pressing and releasing the mouse at a place.
    ui::Commands click(const ui::State& state, float x, float y) {
        ui::Commands all;
        const auto add = [&all](const ui::Commands& more) { all.insert(all.end(), more.begin(), more.end()); };
        move_mouse(x, y);
        add(frame(state));
        press(true);
        add(frame(state));
        press(false);
        add(frame(state));
        return all;
    }

    /// Everything that can be read in what `content` draws.
    template <class Content>
    std::string text(const Content& content) {
        for (int i = 0; i < 3; ++i) {  // a window finds its size in its first frames
            ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
            ImGui::NewFrame();
            ImGui::SetNextWindowPos(ImVec2(0.0f, 0.0f));
            ImGui::Begin("text", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
            ImGui::LogToClipboard();
            content();
            ImGui::LogFinish();
            ImGui::End();
            ImGui::Render();
        }
        const char* read = ImGui::GetClipboardText();
        return read == nullptr ? "" : read;
    }

    /// Whether the window of that name was on screen in the last frame.
    bool shows(const char* window) const {
        const ImGuiWindow* found = ImGui::FindWindowByName(window);
        return found != nullptr && found->Active;
    }

    bool popup_open() const {
        return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    }

private:
    void move_mouse(float x, float y) {
#if IMGUI_VERSION_NUM >= 18700
        ImGui::GetIO().AddMousePosEvent(x, y);
#else
        ImGui::GetIO().MousePos = ImVec2(x, y);
#endif
    }
    void press(bool down) {
#if IMGUI_VERSION_NUM >= 18700
        ImGui::GetIO().AddMouseButtonEvent(0, down);
#else
        ImGui::GetIO().MouseDown[0] = down;
#endif
    }
};

}  // namespace ballpit::test
