// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/files.hpp"

#include <fstream>
#include <sstream>

#include "edgewise/input/output_file.hpp"

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
    input::write_output(path.string(), text);
}

}  // namespace edgewise::reports
