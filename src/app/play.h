// Balls that are thrown into a running scene: where they start. Pure functions; SI units.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/scene.h"
#include "ui/play.h"
#include "view/hand.h"

namespace ballpit::app {

/// What fits the scene: radius and density of its largest ball, and a speed that crosses half the box in a second.
ui::PlayOptions usual_play(const Scene& scene);

/// A ball on the ray: it starts where the ray enters the box (a radius away from the walls), or at the eye where that
/// is inside, and behind whatever balls are in its way there. Nothing where the ray misses the box, or no place is
/// free. `balls`: centre, radius.
std::optional<BallSpec> shot(const view::Ray& ray, const view::Box& box, const ui::PlayOptions& options,
                             std::span<const vec4> balls);

/// At most options.cluster balls at rest, hexagonally close-packed around a point on the ray inside the box: the free
/// one nearest to the middle of its way through, else the freest. Sites in walls or balls stay empty; fewer balls,
/// or none, where the sites nearby are taken. Empty where the ray misses the box.
std::vector<BallSpec> cluster(const view::Ray& ray, const view::Box& box, const ui::PlayOptions& options,
                              std::span<const vec4> balls);

}  // namespace ballpit::app
