// OBJ models: the committed one is what it should be, and every way to be broken is refused in words.
#include "view/model.h"

#include <cmath>
#include <fstream>
#include <initializer_list>
#include <set>

#include "support/catch.h"
#include "support/input_error.h"
#include "support/temporary_folder.h"
#include "view/image.h"

using namespace ballpit;
using namespace ballpit::view;
namespace fs = std::filesystem;

namespace {

fs::path write(const test::TemporaryFolder& folder, const std::string& name, const std::string& text) {
    std::ofstream(folder.path() / name, std::ios::binary) << text;
    return folder.path() / name;
}

Model load_text(const std::string& obj) {
    const test::TemporaryFolder folder;
    return load_model(write(folder, "model.obj", obj));
}

std::string complaint(const std::string& obj) {
    return test::complaint_of([&] { load_text(obj); });
}

void check_mentions(const std::string& message, std::initializer_list<const char*> words) {
    CAPTURE(message);
    for (const char* word : words) {
        CAPTURE(word);
        CHECK(message.find(word) != std::string::npos);
    }
}

const std::string tetrahedron_faces = "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";

}  // namespace

TEST_CASE("the committed ball is a closed, textured unit sphere, and so is its coarser form", "[view]") {
    const Model ball = load_model(fs::path(BALLPIT_SOURCE_DIR) / "assets/models/ball.obj");
    REQUIRE(ball.coarser.size() == 1);
    for (const Model* model : {&ball, &ball.coarser.front()}) {
        CHECK(model->closed);
        REQUIRE(model->parts.size() == 1);
        CHECK(model->parts[0].index_count == model->indices.size());
        CHECK(model->parts[0].material.name == "ball");
        CHECK(model->parts[0].material.texture.width == 256);
        CHECK(model->parts[0].material.texture.height == 128);
        for (const Vertex& vertex : model->vertices) {
            REQUIRE(glm::length(vertex.position) == Approx(1.0f).epsilon(1e-5));
            REQUIRE(glm::distance(vertex.normal, vertex.position) < 1e-4f);
            // The mapping that impostors use: v runs from the upper pole to the lower one.
            REQUIRE(vertex.uv.y ==
                    Approx(std::acos(glm::clamp(vertex.position.z, -1.0f, 1.0f)) / 3.14159265f).margin(1e-3));
        }
    }
    CHECK(ball.indices.size() / 3 > 2 * ball.coarser.front().indices.size() / 3);
}

TEST_CASE("a bare model is centred, scaled, and gets normals that point outwards", "[view]") {
    const Model model = load_text("v 1030 1030 30\nv 1030 970 -30\nv 970 1030 -30\nv 970 970 30\n" + tetrahedron_faces);
    CHECK(model.closed);
    CHECK(model.vertices.size() == 4);
    CHECK(model.indices.size() == 12);
    for (const Vertex& vertex : model.vertices) {
        CHECK(glm::length(vertex.position) == Approx(1.0f).epsilon(1e-5));
        CHECK(glm::dot(vertex.normal, vertex.position) > 0.9f);
    }
}

TEST_CASE("polygons become triangles; open or inside-out bodies are not closed", "[view]") {
    const Model square = load_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    CHECK(square.indices.size() == 6);
    CHECK_FALSE(square.closed);
    const Model pentagon = load_text("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 3 0\nv -1 1 0\nf -5 -4 -3 -2 -1\n");
    CHECK(pentagon.indices.size() == 9);
    const Model inside_out =
        load_text("v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 3 2 1\nf 4 3 1\nf 2 4 1\nf 3 4 2\n");
    CHECK_FALSE(inside_out.closed);
}

TEST_CASE("each material becomes a part", "[view]") {
    const test::TemporaryFolder folder;
    fs::create_directories(folder.path() / "sub/art");
    write(folder, "sub/two.mtl", "newmtl red\nKd 1 0 0\nNs 5\nnewmtl picture\nKd 1 1 1\nmap_Kd art\\dot.png\n");
    const std::vector<unsigned char> pixel = {10, 20, 30};
    save_png(folder.path() / "sub/art/dot.png", 1, 1, pixel);
    const Model model = load_model(write(folder, "two.obj",
                                         "mtllib sub/two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                         "usemtl red\nf 1 2 3\nusemtl picture\nf 1 2 4\nusemtl red\nf 1 3 4\n"));
    REQUIRE(model.parts.size() == 2);
    CHECK(model.parts[0].material.name == "red");
    CHECK(model.parts[0].material.diffuse == vec3(1, 0, 0));
    CHECK(model.parts[0].index_count == 6);
    CHECK(model.parts[1].material.texture.pixels == std::vector<unsigned char>{10, 20, 30, 255});
    CHECK(model.parts[1].first_index == 6);
}

TEST_CASE("a broken model is refused with file and reason", "[view]") {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    check_mentions(complaint(""), {"model.obj", "no faces"});
    check_mentions(complaint(corners), {"no faces"});
    check_mentions(complaint(corners + "f 1 2\n"), {"no faces"});
    check_mentions(complaint(corners + "f 1 2 0\n"), {"ine 4"});
    check_mentions(complaint(corners + "f 1 2 4\n"), {"names vertex 4", "expected 1 to 3"});
    check_mentions(complaint(corners + "f 1 2 3 999999999\n"), {"names vertex 999999999"});
    check_mentions(complaint(corners + "f 1 2 3 1 99999999\n"), {"names vertex 99999999"});
    check_mentions(complaint(corners + "f -1 -2 -9\n"), {"model.obj"});
    check_mentions(complaint(corners + "f 1//1 2//1 3//1\n"), {"names normal 1"});
    check_mentions(complaint(corners + "f 1/5 2/5 3/5\n"), {"texture coordinate 5"});
    check_mentions(complaint("v 1e999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), {"finite"});
    check_mentions(complaint("v 1 1 1\nf 1 1 1\n"), {"single point"});
    check_mentions(complaint(std::string("\x89PNG\r\n\x1a\n\0\0\xff", 11)), {"no faces"});
}

TEST_CASE("what a model names must be there", "[view]") {
    const test::TemporaryFolder folder;
    const std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
    const auto complaint_about = [&](const std::string& obj) {
        return test::complaint_of([&] { load_model(write(folder, "model.obj", obj)); });
    };
    check_mentions(test::complaint_of([&] { load_model(folder.path() / "none.obj"); }), {"none.obj"});
    check_mentions(test::complaint_of([&] { load_model(folder.path()); }), {"cannot be opened"});
    check_mentions(complaint_about("mtllib gone.mtl\n" + faces), {"model.obj", "gone.mtl"});
    write(folder, "m.mtl", "newmtl m\nmap_Kd gone.png\n");
    check_mentions(complaint_about("mtllib m.mtl\n" + faces), {"gone.png"});
    write(folder, "m.mtl", "newmtl m\nmap_Kd text.png\n");
    write(folder, "text.png", "not a picture");
    check_mentions(complaint_about("mtllib m.mtl\n" + faces), {"text.png", "unknown"});
    check_mentions(complaint_about("mtllib gone.mtl m.mtl\n" + faces), {"text.png"});
}

TEST_CASE("a picture is written whole or not at all", "[view]") {
    const test::TemporaryFolder folder;
    const std::vector<unsigned char> rgb = {255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 8, 7, 1, 2, 3, 4, 5, 6};
    const fs::path path = folder.path() / "picture.png";
    save_png(path, 3, 2, rgb);
    const Image image = load_image(path);
    CHECK(image.width == 3);
    CHECK(image.height == 2);
    REQUIRE(image.pixels.size() == 24);
    CHECK(image.pixels[4] == 0);
    CHECK(image.pixels[5] == 255);
    CHECK(image.pixels[12] == 9);  // the second row
    check_mentions(test::complaint_of([&] { save_png(folder.path() / "no/such/folder.png", 3, 2, rgb); }),
                   {"folder.png", "No such file"});
    fs::create_directory(folder.path() / "taken.png");
    check_mentions(test::complaint_of([&] { save_png(folder.path() / "taken.png", 3, 2, rgb); }), {"taken.png"});
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path())) {
        names.insert(entry.path().filename().string());
    }
    CHECK(names == std::set<std::string>{"picture.png", "taken.png"});
}
