#include "app/window_place.h"

#include <algorithm>

namespace ballpit::app {

namespace {

constexpr int handle = 100;  // points that must be on a display, so that a hand can reach the rest

bool reachable(const SDL_Rect& window, const SDL_Rect& display) {
    SDL_Rect common;
    return SDL_IntersectRect(&window, &display, &common) == SDL_TRUE && common.w >= handle && common.h >= handle &&
           window.y >= display.y;
}

}  // namespace

WindowPlace place_of(SDL_Window* window) {
    WindowPlace place;
    SDL_GetWindowPosition(window, &place.x, &place.y);
    SDL_GetWindowSize(window, &place.width, &place.height);
    return place;
}

void put(SDL_Window* window, const WindowPlace& place) {
    SDL_Rect wanted{place.x, place.y, place.width, place.height};
    for (int i = 0; i < SDL_GetNumVideoDisplays(); ++i) {
        SDL_Rect display;
        if (SDL_GetDisplayUsableBounds(i, &display) == 0 && reachable(wanted, display)) {
            wanted.w = std::min(wanted.w, display.w);
            wanted.h = std::min(wanted.h, display.h);
            SDL_SetWindowSize(window, wanted.w, wanted.h);
            SDL_SetWindowPosition(window, wanted.x, wanted.y);
            return;
        }
    }
}

}  // namespace ballpit::app
