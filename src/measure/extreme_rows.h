// The cases, one function each; the table in extremes.cpp says what they are.
#pragma once

#include "measure/extreme_trial.h"

namespace ballpit::measure {

void coincident_centres(ExtremeTrial& trial);
void numbers_that_are_none(ExtremeTrial& trial);
void enormous_speed(ExtremeTrial& trial);
void few_balls(ExtremeTrial& trial);
void odd_counts(ExtremeTrial& trial);
void all_in_one_cell(ExtremeTrial& trial);
void outside_the_box(ExtremeTrial& trial);
void larger_than_the_box(ExtremeTrial& trial);
void eight_decades_of_stiffness(ExtremeTrial& trial);
void zero_stiffness(ExtremeTrial& trial);
void impossible_input(ExtremeTrial& trial);
void no_time(ExtremeTrial& trial);
void tunnelling(ExtremeTrial& trial);
void deep_overlap(ExtremeTrial& trial);
void overdamped(ExtremeTrial& trial);
void drag_beyond_two(ExtremeTrial& trial);
void beyond_the_critical_step(ExtremeTrial& trial);
void heating_integrator(ExtremeTrial& trial);
void large_coordinates(ExtremeTrial& trial);
void a_million_steps_of_the_clock(ExtremeTrial& trial);
void tiny_substep(ExtremeTrial& trial);
void unequal_radii(ExtremeTrial& trial);
void unequal_masses(ExtremeTrial& trial);
void many_bounces(ExtremeTrial& trial);
void order_of_neighbours(ExtremeTrial& trial);
void walls_closing_in(ExtremeTrial& trial);
void changed_while_running(ExtremeTrial& trial);

}  // namespace ballpit::measure
