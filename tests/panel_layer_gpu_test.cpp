// The layer of panels: one that was brought up to date again and again is the same picture as one drawn anew.
#include "app/panel_layer.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <optional>
#include <string>
#include <vector>

#include "support/gl_fixture.h"
#include "support/studio.h"

using namespace ballpit;
using namespace ballpit::test;

namespace {

// A panel of this frame.
struct Panel {
    const char* name;
    ImVec2 place;
    ImVec2 size;
    std::string text;
};

class Gui {
public:
    Gui() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
        ImGui_ImplOpenGL3_Init("#version 330 core");
    }
    ~Gui() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui::DestroyContext();
    }
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    static void make(const std::vector<Panel>& panels) {
        ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
        ImGui_ImplOpenGL3_NewFrame();
        ImGui::NewFrame();
        for (const Panel& panel : panels) {
            ImGui::SetNextWindowPos(panel.place);
            ImGui::SetNextWindowSize(panel.size);
            ImGui::SetNextWindowBgAlpha(0.5f);
            ImGui::Begin(panel.name, nullptr, ImGuiWindowFlags_NoSavedSettings);
            ImGui::TextUnformatted(panel.text.c_str());
            ImGui::End();
        }
        ImGui::Render();
    }
};

Pixels laid_over(const app::PanelLayer& layer) {
    const gl::Framebuffer framebuffer(width, height);
    framebuffer.bind();
    glClearColor(0.2f, 0.4f, 0.6f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    layer.lay_over();
    glUseProgram(0);  // ImGui would go back to a program that is gone with its layer
    return framebuffer.pixels();
}

}  // namespace

TEST_CASE_METHOD(test::GlFixture, "panels brought up to date are panels drawn anew", "[view]") {
    const Gui gui;
    const gl::Framebuffer window(width, height);
    window.bind();
    app::PanelLayer kept(source("glsl"));
    const Panel left{"left", {10, 10}, {120, 80}, "one"};
    const Panel right{"right", {180, 10}, {120, 200}, "two"};
    const Panel across{"across", {100, 50}, {120, 60}, "three"};  // overlaps both
    Panel other = left;
    other.text = "another text";
    Panel moved = right;
    moved.place = {150, 40};
    Panel smaller = left;
    smaller.size = {60, 40};
    std::optional<Pixels> before;
    int differing = 0;
    for (const std::vector<Panel>& panels : std::vector<std::vector<Panel>>{{left, right},
                                                                            {other, right},
                                                                            {other, right},
                                                                            {other, moved},
                                                                            {smaller, moved},
                                                                            {left, right, across},
                                                                            {left, moved, across},
                                                                            {left},
                                                                            {},
                                                                            {right}}) {
        CAPTURE(panels.size());
        window.bind();
        for (int frame = 0; frame < 3; ++frame) {  // ImGui shows a new window a frame later
            Gui::make(panels);
            kept.draw(0.0, width, height);
        }
        app::PanelLayer fresh(source("glsl"));
        fresh.draw(0.0, width, height);
        const Pixels seen = laid_over(kept);
        CHECK(count(changed(seen, laid_over(fresh))) == 0);
        differing += before && count(changed(seen, *before)) > 0 ? 1 : 0;
        before = seen;
    }
    CHECK(differing == 8);  // all but the two that are the same
}

TEST_CASE_METHOD(test::GlFixture, "a layer of another size starts empty", "[view]") {
    const Gui gui;
    const gl::Framebuffer window(width, height);
    window.bind();
    app::PanelLayer layer(source("glsl"));
    CHECK(layer.due(false, 0.0, width, height));
    Gui::make({{"one", {10, 10}, {120, 80}, "one"}});
    Gui::make({{"one", {10, 10}, {120, 80}, "one"}});
    layer.draw(0.0, width, height / 2);
    CHECK_FALSE(layer.due(false, 0.0, width, height / 2));
    CHECK(layer.due(false, 0.0, width, height));
    CHECK(layer.due(false, 1.0, width, height / 2));
    CHECK(layer.due(true, 0.0, width, height / 2));
    layer.draw(0.0, width, height);
    app::PanelLayer fresh(source("glsl"));
    fresh.draw(0.0, width, height);
    CHECK(count(changed(laid_over(layer), laid_over(fresh))) == 0);
}
