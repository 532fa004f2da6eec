// What every backend must do besides computing: load, read, write, ask for copies, time, save.
#pragma once

#include "core/backend.h"

namespace ballpit::test {

void reads_what_was_loaded(Backend& backend);
void reads_what_was_written(Backend& backend);
void copies_arrive_as_of_the_request(Backend& backend);
void buffers_grow_and_shrink(Backend& backend);
void reschedules_in_the_middle(Backend& backend);
void times_every_stage(Backend& backend);
void status_adds_up(Backend& backend);
void saves_and_restores(Backend& backend);
void hashes_the_state(Backend& backend);
void remembers_states(Backend& backend);
/// Without contacts there is one state: nothing in next_*, and all the rest holds.
void works_in_place(Backend& backend);

}  // namespace ballpit::test
