#include "view/image.h"

#include <cassert>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "view/stb.h"

namespace ballpit::view {

namespace fs = std::filesystem;

namespace {

std::vector<unsigned char> read_file(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream || fs::is_directory(path)) {
        throw InputError("cannot open picture " + path.string() + ": expected a readable file");
    }
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

bool write_file(const fs::path& path, const std::vector<char>& bytes) {
    std::ofstream stream(path, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    return stream.good();
}

}  // namespace

Image load_image(const fs::path& path) {
    std::string reason;
    std::optional<Image> image = stb::decode(read_file(path), reason);
    if (!image) {
        throw InputError("cannot read picture " + path.string() + ": " + reason);
    }
    return std::move(*image);
}

void save_png(const fs::path& path, int width, int height, std::span<const unsigned char> rgb) {
    assert(rgb.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    const std::vector<char> png = stb::encode_png(width, height, rgb);
    std::error_code error;
    // A device, a pipe or a link is written to: renaming a file over it would put the file in its place.
    const bool special = fs::is_other(path, error) || fs::is_symlink(path, error);
    fs::path part = path;
    part += special ? "" : ".part";
    errno = 0;
    if (png.empty() || !write_file(part, png)) {
        const std::string reason = errno != 0 ? std::strerror(errno) : "out of memory";
        if (!special) {
            fs::remove(part, error);
        }
        throw InputError("cannot write picture " + path.string() + ": " + reason);
    }
    if (special) {
        return;
    }
    fs::rename(part, path, error);
    if (error) {
        const std::string reason = error.message();
        fs::remove(part, error);
        throw InputError("cannot write picture " + path.string() + ": " + reason);
    }
}

}  // namespace ballpit::view
