// Output files that are either whole or not there.
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>

namespace ballpit::app {

/// Writes beside the wanted place and renames on commit(). Without a commit, nothing is left behind. A device, a
/// pipe or a link is written to directly.
class AtomicFile {
public:
    /// Throws InputError if nothing can be written there.
    explicit AtomicFile(std::filesystem::path path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    std::ostream& stream() { return stream_; }
    /// Throws InputError if the disk is full or the place cannot be written.
    void commit();

private:
    void discard();

    std::filesystem::path path_;
    std::filesystem::path temporary_;
    std::ofstream stream_;
};

}  // namespace ballpit::app
