// A law that is compiled in and whose coefficient is zero changes no bit: what every backend is held to.
#pragma once

#include <functional>
#include <memory>

#include "core/backend.h"
#include "core/integrator.h"

namespace ballpit::test {

using MakeBackend = std::function<std::unique_ptr<Backend>()>;

/// For every law: the state hash after `steps` steps with the law compiled out and compiled in.
void zero_laws_change_no_bit(const MakeBackend& make_backend, Integrator integrator, int steps);

}  // namespace ballpit::test
