#include "view/obj_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/error.h"

namespace ballpit::view {

namespace fs = std::filesystem;

namespace {

// The loader's words, which come as lines, as a part of a sentence.
std::string one_line(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

std::string read_text(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream || fs::is_directory(path)) {
        refuse_model(path, "cannot be opened: expected a readable OBJ file");
    }
    std::ostringstream text;
    text << stream.rdbuf();
    return std::move(text).str();
}

// Finds material files beside the model and textures beside their material file. The loader's own reader would only
// warn of a missing one and draw the model grey.
class MaterialsBeside : public tinyobj::MaterialReader {
public:
    explicit MaterialsBeside(const fs::path& model) : model_(model) {}

    bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* ids, std::string* warnings, std::string* errors) override {
        const fs::path path = model_.parent_path() / name;
        std::ifstream stream(path);
        if (!stream || fs::is_directory(path)) {
            missing_ = path;
            return false;
        }
        const std::size_t before = materials->size();
        tinyobj::LoadMtl(ids, materials, &stream, warnings, errors);
        for (std::size_t i = before; i < materials->size(); ++i) {
            std::string& texture = (*materials)[i].diffuse_texname;
            if (!texture.empty()) {
                texture = (path.parent_path() / portable(texture)).string();
            }
        }
        missing_.clear();  // a mtllib line may name several: the first that is there counts
        return true;
    }

    const fs::path& missing() const { return missing_; }

private:
    static std::string portable(std::string name) {
        std::ranges::replace(name, '\\', '/');
        return name;
    }

    const fs::path& model_;
    fs::path missing_;
};

void check_index(const fs::path& path, const char* kind, int index, std::size_t count, bool optional) {
    if (index >= 0 ? static_cast<std::size_t>(index) >= count : !optional) {
        refuse_model(path, "a face names " + std::string(kind) + " " + std::to_string(static_cast<long>(index) + 1) +
                               ": expected 1 to " + std::to_string(count));
    }
}

void check_numbers(const fs::path& path, const ObjFile& file) {
    const tinyobj::attrib_t& a = file.attributes;
    for (const auto* numbers : {&a.vertices, &a.normals, &a.texcoords}) {
        if (!std::ranges::all_of(*numbers, [](auto x) { return std::isfinite(x); })) {
            refuse_model(path, "a coordinate is not a finite number");
        }
    }
    for (const tinyobj::shape_t& shape : file.shapes) {
        for (const tinyobj::index_t& index : shape.mesh.indices) {
            check_index(path, "vertex", index.vertex_index, a.vertices.size() / 3, false);
            check_index(path, "normal", index.normal_index, a.normals.size() / 3, true);
            check_index(path, "texture coordinate", index.texcoord_index, a.texcoords.size() / 2, true);
        }
    }
}

ObjFile parse(const fs::path& path, const std::string& text, bool triangulate) {
    ObjFile file;
    MaterialsBeside reader(path);
    std::istringstream stream(text);
    std::string warnings;
    std::string errors;
    if (!tinyobj::LoadObj(&file.attributes, &file.shapes, &file.materials, &warnings, &errors, &stream, &reader,
                          triangulate)) {
        refuse_model(path, one_line(errors + warnings));
    }
    if (!reader.missing().empty()) {
        refuse_model(path, "cannot open its material file " + reader.missing().string());
    }
    check_numbers(path, file);
    return file;
}

}  // namespace

ObjFile read_obj(const fs::path& path) {
    const std::string text = read_text(path);
    // The loader drops faces with bad indices while it cuts polygons up (or, built with earcut, does not look), so
    // the whole polygons are looked at first.
    parse(path, text, false);
    return parse(path, text, true);
}

void refuse_model(const fs::path& path, const std::string& reason) {
    throw InputError("model " + path.string() + ": " + reason);
}

}  // namespace ballpit::view
