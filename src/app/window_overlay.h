// What the picture shows on top of the balls, from what is selected and what the views know.
#pragma once

#include "ui/inspection.h"
#include "view/overlay.h"

namespace ballpit::app {

view::Overlay make_overlay(const ui::Inspection& inspection);

/// Whether the picture changes though nothing moves.
bool blinks(const view::Overlay& overlay);

}  // namespace ballpit::app
