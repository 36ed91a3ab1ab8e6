// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/files.hpp"

#include <fmt/core.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace edgewise::reports {

std::optional<std::string> read_file(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) return std::nullopt;
    std::ostringstream text;
    text << in.rdbuf();
    if (in.bad() || text.bad()) return std::nullopt;
    return text.str();
}

void write_file(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::path temporary = path;
    temporary += ".tmp";
    {
        std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
        out.close();
        if (!out)
            throw std::runtime_error(
                fmt::format("cannot write {}: check that the directory is writable", path.string()));
    }
    std::error_code failed;
    std::filesystem::rename(temporary, path, failed);
    if (failed) throw std::runtime_error(fmt::format("cannot write {}: {}", path.string(), failed.message()));
}

}  // namespace edgewise::reports
