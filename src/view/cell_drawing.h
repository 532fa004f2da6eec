// Draws the occupied cells of the grid, coloured by how many balls each holds.
#pragma once

#include <filesystem>

#include "gl/program.h"
#include "gl/vertex_array.h"
#include "view/picture.h"

namespace ballpit::view {

class CellDrawing {
public:
    explicit CellDrawing(const std::filesystem::path& shader_folder);
    void draw(const Picture& picture);

private:
    gl::Program program_;
    gl::VertexArray array_;
};

}  // namespace ballpit::view
