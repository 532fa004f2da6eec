#include "gl/shader_source.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "gl/error.h"

namespace ballpit::gl {

namespace {

namespace fs = std::filesystem;

class Loader {
public:
    Loader(const fs::path& folder, const std::vector<std::string_view>& defines) : folder_(folder), defines_(defines) {}

    void append(const std::string& file, const std::string& from) {
        if (std::ranges::find(source.files, fs::path(file)) != source.files.end()) {
            return;  // included already
        }
        std::ifstream stream(folder_ / file);
        if (!stream) {
            throw ShaderError(from + "cannot open shader file " + (folder_ / file).string());
        }
        const std::size_t number = source.files.size();
        source.files.emplace_back(file);
        if (number != 0) {
            mark_line(1, number);
        }
        std::string line;
        for (int count = 1; std::getline(stream, line); ++count) {
            append_line(line, file, count, number);
        }
    }

    ShaderSource source;

private:
    void mark_line(int line, std::size_t number) {
        source.text += "#line " + std::to_string(line) + " " + std::to_string(number) + "\n";
    }

    void append_line(const std::string& line, const std::string& file, int count, std::size_t number) {
        static const std::regex include_pattern(R"re(^\s*#\s*include\s+"([^"]+)"\s*(//.*)?$)re");
        static const std::regex include_start(R"re(^\s*#\s*include\b)re");
        std::smatch match;
        if (std::regex_match(line, match, include_pattern)) {
            append(match[1], file + ":" + std::to_string(count) + ": ");
            mark_line(count + 1, number);
        } else if (std::regex_search(line, include_start)) {
            throw ShaderError(file + ":" + std::to_string(count) + ": expected #include \"file\", found: " + line);
        } else {
            source.text += line + "\n";
            if (line.starts_with("#version")) {
                for (const std::string_view define : defines_) {
                    source.text += "#define " + std::string(define) + "\n";
                }
                mark_line(count + 1, number);
            }
        }
    }

    const fs::path& folder_;
    const std::vector<std::string_view>& defines_;
};

}  // namespace

ShaderSource load_shader(const fs::path& folder, const std::string& file,
                         const std::vector<std::string_view>& defines) {
    Loader loader(folder, defines);
    loader.append(file, "");
    loader.source.name = file;
    for (const std::string_view define : defines) {
        loader.source.name.append(" ").append(define);
    }
    return std::move(loader.source);
}

std::string readable_log(const ShaderSource& source, const std::string& log) {
    static const std::regex place(R"((^|\bERROR: |\bWARNING: )(\d+)(?::(\d+)|\((\d+)\)))");
    std::istringstream lines(log);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_search(line, match, place)) {
            const std::size_t number = std::stoul(match[2]);
            if (number < source.files.size()) {
                const std::string at = match[3].matched ? match[3].str() : match[4].str();
                line = match.prefix().str() + match[1].str() + source.files[number].string() + ":" + at +
                       match.suffix().str();
            }
        }
        result += line + "\n";
    }
    return result;
}

}  // namespace ballpit::gl
