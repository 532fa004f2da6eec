#include "app/atomic_file.h"

#if defined(_WIN32)
#include <fcntl.h>
#include <io.h>
#else
#include <fcntl.h>
#include <unistd.h>
#endif

#include <cerrno>
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

// Until then a rename may reach the disk before what was written: after a power failure the file would be empty.
bool reaches_disk(const std::filesystem::path& path) {
#if defined(_WIN32)
    const int file = _wopen(path.c_str(), _O_RDWR | _O_BINARY);
    const bool done = file >= 0 && _commit(file) == 0;
    return file >= 0 && _close(file) == 0 && done;
#else
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool done = file >= 0 && (::fsync(file) == 0 || errno == EINVAL);  // a file system that has no such thing
    return file >= 0 && ::close(file) == 0 && done;
#endif
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
    bool whole = static_cast<bool>(stream_);
    if (whole && temporary_ != path_) {
        whole = reaches_disk(temporary_);
        if (whole) {
            std::filesystem::rename(temporary_, path_, error);
        }
    }
    if (!whole || error) {
        discard();
        throw InputError(path_.string() + ": could not be written to the end; is the disk full?");
    }
}

}  // namespace ballpit::app
