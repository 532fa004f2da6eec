// Compiled programs, without data: changing the scene or the backend keeps them. Those that shipped scenes use can be
// built ahead; any other permutation is compiled when it is first asked for, and noted.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "core/schedule.h"
#include "gl/program.h"
#include "gpu/params_block.h"

namespace ballpit::gpu {

class Programs {
public:
    explicit Programs(std::filesystem::path shader_folder) : folder_(std::move(shader_folder)) {}

    struct Compiled {
        gl::Program program;
        ParamsBlock params;
        GLint dispatch_constants = -1;  // uniform location
        std::array<std::uint32_t, 4> set_constants{};

        /// While the program is in use. A driver may take its time over a uniform, so only those that differ are set.
        void set(const std::array<std::uint32_t, 4>& constants) {
            if (dispatch_constants >= 0 && constants != set_constants) {
                glUniform4uiv(dispatch_constants, 1, constants.data());
                set_constants = constants;
            }
        }
    };

    /// Throws gl::ShaderError with file, line and the driver's log.
    Compiled& get(const Program& program);

    /// The programs that are worth building ahead.
    void set_shipped(std::span<const Program> programs) { shipped_.insert(programs.begin(), programs.end()); }
    /// Compiles one of them that is not there yet; false when all are. Throws as get().
    bool build_one();

    /// A permutation that was compiled though it is none of those, and how long that took.
    struct OnDemand {
        Program program;
        double ms = 0.0;
    };
    std::span<const OnDemand> on_demand() const { return on_demand_; }

    const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
    std::map<Program, Compiled> compiled_;
    std::set<Program> shipped_;
    std::vector<OnDemand> on_demand_;
};

/// The #defines of a permutation.
std::vector<std::string_view> defines_of(Features features);

}  // namespace ballpit::gpu
