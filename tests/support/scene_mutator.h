// Scene files that are nearly right: changed part by part (as a tree) and byte by byte (as text).
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ballpit::test {

class SceneMutator {
public:
    /// The scene files of these folders, sorted by name, are where every case starts.
    explicit SceneMutator(const std::vector<std::filesystem::path>& folders);

    std::size_t corpus_size() const { return texts_.size(); }

    /// The text of one case: the same for the same two numbers.
    std::string text(std::uint64_t seed, std::uint64_t number) const;

private:
    std::vector<std::string> texts_;
    std::vector<nlohmann::json> trees_;
};

}  // namespace ballpit::test
