#include "app/atomic_file.h"

#include <system_error>

#include "core/error.h"

namespace ballpit::app {

namespace {

// A device, a pipe or a link is written to: renaming a file over it would put the file in its place.
std::filesystem::path place_to_write(const std::filesystem::path& path) {
    std::error_code ignored;
    const bool special = std::filesystem::is_other(path, ignored) || std::filesystem::is_symlink(path, ignored);
    return special ? path : std::filesystem::path(path.string() + ".part");
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)), temporary_(place_to_write(path_)), stream_(temporary_, std::ios::binary) {
    if (!stream_ || std::filesystem::is_directory(path_)) {
        discard();
        throw InputError(path_.string() +
                         ": cannot be written; expected a file in a folder that exists and is writable");
    }
}

AtomicFile::~AtomicFile() {
    if (stream_.is_open()) {
        discard();
    }
}

void AtomicFile::discard() {
    stream_.close();
    if (temporary_ != path_) {
        std::error_code ignored;
        std::filesystem::remove(temporary_, ignored);
    }
}

void AtomicFile::commit() {
    stream_.close();
    std::error_code error;
    if (stream_ && temporary_ != path_) {
        std::filesystem::rename(temporary_, path_, error);
    }
    if (!stream_ || error) {
        discard();
        throw InputError(path_.string() + ": could not be written to the end; is the disk full?");
    }
}

}  // namespace ballpit::app
