#include "view/cell_drawing.h"

#include <cassert>

#include "core/layout.h"
#include "view/view_program.h"

namespace ballpit::view {

CellDrawing::CellDrawing(const std::filesystem::path& shader_folder)
    : program_(load_view_program(shader_folder, "cell")) {}

void CellDrawing::draw(const Picture& picture) {
    constexpr GLuint at_range = 3;
    constexpr GLsizei strip_length = 14;
    const std::uint32_t cells = picture.grid.cell_count();
    assert(picture.cell_ranges->size() >= cells * sizeof(CellRange));
    array_.uints(at_range, *picture.cell_ranges, 2, sizeof(CellRange), 0, 1);
    program_.use();
    array_.bind();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);  // a veil hides nothing
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, strip_length, static_cast<GLsizei>(cells));
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDisable(GL_CULL_FACE);
}

}  // namespace ballpit::view
