#include "app/atomic_file.h"

#include <system_error>

#include "core/error.h"

namespace ballpit::app {

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)), temporary_(path_.string() + ".part"), stream_(temporary_, std::ios::binary) {
    if (!stream_ || std::filesystem::is_directory(path_)) {
        stream_.close();
        std::error_code ignored;
        std::filesystem::remove(temporary_, ignored);
        throw InputError(path_.string() + ": cannot be written; expected a file in a folder that exists and is writable");
    }
}

AtomicFile::~AtomicFile() {
    if (stream_.is_open()) {
        stream_.close();
        std::error_code ignored;
        std::filesystem::remove(temporary_, ignored);
    }
}

void AtomicFile::commit() {
    stream_.close();
    std::error_code error;
    if (stream_) {
        std::filesystem::rename(temporary_, path_, error);
    }
    if (!stream_ || error) {
        std::error_code ignored;
        std::filesystem::remove(temporary_, ignored);
        throw InputError(path_.string() + ": could not be written to the end; is the disk full?");
    }
}

}  // namespace ballpit::app
