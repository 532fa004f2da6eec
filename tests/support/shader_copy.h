// A copy of the shaders that a test may spoil.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "support/catch.h"
#include "support/gpu_backend.h"
#include "support/temporary_folder.h"

namespace ballpit::test {

inline std::string file_text(const std::filesystem::path& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

class ShaderCopy {
public:
    ShaderCopy() { std::filesystem::copy(shader_folder(), folder_.path(), std::filesystem::copy_options::recursive); }
    const std::filesystem::path& path() const { return folder_.path(); }
    void write(const std::string& file, const std::string& text) const { std::ofstream(folder_.path() / file) << text; }
    /// The first place where the file says `right`; there must be one.
    void replace(const std::string& file, const std::string& right, const std::string& wrong) const {
        std::string text = file_text(folder_.path() / file);
        const std::size_t place = text.find(right);
        INFO(file << " has no \"" << right << "\"");
        REQUIRE(place != std::string::npos);
        write(file, text.replace(place, right.size(), wrong));
    }

private:
    TemporaryFolder folder_;
};

}  // namespace ballpit::test
