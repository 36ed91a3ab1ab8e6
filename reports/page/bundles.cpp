// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/bundles.hpp"

#include <sstream>

#include "edgewise/reports/page/files.hpp"
#include "edgewise/reports/page/packing.hpp"

namespace edgewise::reports {

namespace {

/// vega first: the others look for it when they load.
const char* const bundle_names[] = {"vega", "vega-lite", "vega-embed"};

/// Developer tools would fetch what such a line names.
std::string without_source_map(const std::string& text) {
    std::istringstream lines(text);
    std::string kept, line;
    while (std::getline(lines, line))
        if (line.find("sourceMappingURL=") == std::string::npos || !line.starts_with("//"))
            (kept += line) += '\n';
    return kept;
}

}  // namespace

bool have_bundles(const std::filesystem::path& directory) {
    std::error_code ignored;
    for (const char* name : bundle_names)
        if (!std::filesystem::is_regular_file(directory / (std::string(name) + ".min.js"), ignored))
            return false;
    return true;
}

std::string bundle_elements(const std::filesystem::path& directory) {
    std::string out;
    for (const std::string name : bundle_names) {
        const auto script = read_file(directory / (name + ".min.js"));
        if (!script) return {};
        const auto licence = read_file(directory / (name + ".LICENSE"));
        const std::string text = (licence ? "/*! " + name + "\n" + *licence + "*/\n" : "") + *script;
        out += packed_element("bundle-" + name, without_source_map(text));
    }
    return out;
}

}  // namespace edgewise::reports
