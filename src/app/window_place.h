// Where the window stands on the desk.
#pragma once

#include <SDL.h>

#include "app/user_settings.h"

namespace ballpit::app {

WindowPlace place_of(SDL_Window* window);

/// Puts it there, as far as there still is a display: never larger than one, never where nobody sees it.
void put(SDL_Window* window, const WindowPlace& place);

}  // namespace ballpit::app
