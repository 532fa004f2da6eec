#include "app/window_gui.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>
#if __has_include(<imgui_impl_sdl2.h>)
#include <imgui_impl_sdl2.h>
#else
#include <imgui_impl_sdl.h>
#endif

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/style.h"

namespace ballpit::app {

namespace {

constexpr int design_height = 720;  // points: the window that ui::font_height is meant for

// Latin, Greek and Cyrillic for names in scene files; arrows, mathematics and shapes for the panels.
constexpr ImWchar glyph_ranges[] = {0x0020, 0x017F, 0x0370, 0x04FF, 0x2000, 0x206F, 0x2070, 0x209F,
                                    0x2190, 0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

// From 1.92 on ImGui makes glyphs as they are needed, at any size; before, a size needs its own texture.
#if IMGUI_VERSION_NUM >= 19200
constexpr bool fonts_scale_themselves = true;
#else
constexpr bool fonts_scale_themselves = false;
#endif

void add_font(const std::filesystem::path& file, float pixels) {
    ImGuiIO& io = ImGui::GetIO();
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error)) {
        io.Fonts->AddFontFromFileTTF(file.string().c_str(), pixels, nullptr, glyph_ranges);
        return;
    }
    ImFontConfig config;
    config.SizePixels = pixels;
    io.Fonts->AddFontDefault(&config);
}

void set_font(const std::filesystem::path& file, float points, float pixel_ratio) {
    const float pixels = std::round(points * pixel_ratio);
#if IMGUI_VERSION_NUM >= 19200
    if (ImGui::GetIO().Fonts->Fonts.empty()) {
        add_font(file, pixels);
    }
    ImGui::GetStyle().FontSizeBase = pixels / pixel_ratio;
#else
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    add_font(file, pixels);
    io.FontGlobalScale = 1.0f / pixel_ratio;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

}  // namespace

Gui::Gui(const gl::Context& context, std::filesystem::path font_file)
    : window_(context.window()), font_file_(std::move(font_file)) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // the window keeps it with the rest of the user's settings
    ImGui_ImplSDL2_InitForOpenGL(window_, context.handle());
    ImGui_ImplOpenGL3_Init("#version 330 core");
    if (!fonts_scale_themselves) {
        ImGui_ImplOpenGL3_NewFrame();  // makes the objects of the backend, which a font's texture is one of
    }
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
}

void Gui::process(const SDL_Event& event) const {
    // Tab hides the panels. ImGui would also let it start typing into a slider.
    const bool tab = event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_TAB;
    if (!tab || typing()) {
        ImGui_ImplSDL2_ProcessEvent(&event);
    }
}

void Gui::rescale(float text_size) {
    int width = 0;
    int height = 0;
    int pixels = 0;
    SDL_GetWindowSize(window_, &width, &height);
    SDL_GL_GetDrawableSize(window_, nullptr, &pixels);
    // In eighths: not every size of a window that is being pulled larger is worth a font of its own.
    const float wanted = text_size * static_cast<float>(height) / static_cast<float>(design_height);
    const float scale = std::clamp(std::round(wanted * 8.0f) / 8.0f, 0.625f, 6.0f);
    const float ratio = height > 0 ? static_cast<float>(pixels) / static_cast<float>(height) : 1.0f;
    if (scale != scale_ || ratio != pixel_ratio_) {
        scale_ = scale;
        pixel_ratio_ = std::max(ratio, 0.5f);
        ui::apply_style(scale_);
        set_font(font_file_, ui::font_height * scale_, pixel_ratio_);
    }
}

void Gui::begin_frame(float text_size) {
    if (!holding()) {  // a slider that changes the size must not move away from under the pointer
        rescale(text_size);
    }
    ImGui_ImplOpenGL3_NewFrame();
#if IMGUI_VERSION_NUM < 18500
    ImGui_ImplSDL2_NewFrame(window_);
#else
    ImGui_ImplSDL2_NewFrame();
#endif
    ImGui::NewFrame();
}

void Gui::end_frame() const { ImGui::Render(); }

void Gui::render() const { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

std::string Gui::layout() const { return ImGui::SaveIniSettingsToMemory(); }

void Gui::set_layout(const std::string& layout) { ImGui::LoadIniSettingsFromMemory(layout.c_str(), layout.size()); }

bool Gui::typing() const { return ImGui::GetIO().WantTextInput; }

bool Gui::over_panel() const { return ImGui::GetIO().WantCaptureMouse; }

bool Gui::holding() const { return ImGui::IsAnyItemActive(); }

void Gui::show_hand() { ImGui::SetMouseCursor(ImGuiMouseCursor_Hand); }

bool Gui::popup_open() const {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

}  // namespace ballpit::app
