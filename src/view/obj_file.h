// An OBJ file with its material files, as the loader gives it, but with everything checked that the loader lets pass.
#pragma once

#include <tiny_obj_loader.h>

#include <filesystem>
#include <string>

namespace ballpit::view {

/// Triangles only; every index names something that is there, every number is finite, and texture names are paths.
struct ObjFile {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
};

/// Throws InputError with file and reason.
ObjFile read_obj(const std::filesystem::path& path);

/// Throws the InputError that says why this model is refused.
[[noreturn]] void refuse_model(const std::filesystem::path& path, const std::string& reason);

}  // namespace ballpit::view
