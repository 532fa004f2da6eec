// What a program asks for, by the driver's word: storage blocks, constants of its block, uniforms.
#pragma once

#include <filesystem>
#include <string>

#include "core/schedule.h"
#include "gpu/programs.h"

namespace ballpit::test {

/// "collide LAW_GRAVITY DIAGNOSTICS"
std::string program_title(const Program& program);

/// The title and a line each for buffers (with bindings), constants and uniforms, each sorted by name.
std::string program_paragraph(gpu::Programs& programs, const Program& program);

}  // namespace ballpit::test
