// A law that is compiled in and whose coefficient is zero changes no bit: what every backend is held to.
#pragma once

#include <functional>
#include <memory>

#include "core/backend.h"
#include "core/settings.h"

namespace ballpit::test {

using MakeBackend = std::function<std::unique_ptr<Backend>()>;

/// For every law: the state hash after 1000 steps with the law compiled out and compiled in.
void zero_laws_change_no_bit(const MakeBackend& make_backend, Integrator integrator, NeighbourSearch neighbours);

}  // namespace ballpit::test
