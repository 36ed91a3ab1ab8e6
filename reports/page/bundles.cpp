// SPDX-License-Identifier: MIT
//
// In a <script> element only "</script" and "<!--" have a meaning for HTML; in the bundles
// both can stand only inside string or regular-expression literals, where a backslash in front changes
// nothing.
#include "edgewise/reports/page/bundles.hpp"

#include <cctype>
#include <sstream>

#include "edgewise/reports/page/files.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

/// vega first: the others look for it when they load.
const char* const bundle_names[] = {"vega", "vega-lite", "vega-embed"};

bool starts_with_ignoring_case(const std::string& text, std::size_t at, const std::string& prefix) {
    if (at + prefix.size() > text.size()) return false;
    for (std::size_t i = 0; i < prefix.size(); ++i)
        if (std::tolower(static_cast<unsigned char>(text[at + i])) != prefix[i]) return false;
    return true;
}

}  // namespace

bool have_bundles(const std::filesystem::path& directory) {
    std::error_code ignored;
    for (const char* name : bundle_names)
        if (!std::filesystem::is_regular_file(directory / (std::string(name) + ".min.js"), ignored))
            return false;
    return true;
}

std::string inline_script(const std::string& text) {
    std::istringstream lines(text);
    std::string kept, line;
    while (std::getline(lines, line))
        if (line.find("sourceMappingURL=") == std::string::npos || line.compare(0, 2, "//") != 0)
            (kept += line) += '\n';
    std::string safe;
    safe.reserve(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        safe += kept[i];
        if (kept[i] == '<' &&
            (starts_with_ignoring_case(kept, i, "</script") || kept.compare(i, 4, "<!--") == 0))
            safe += '\\';
    }
    return safe;
}

std::string inline_json(const std::string& json) { return replaced(json, {{'<', "\\u003c"}}); }

std::string bundle_scripts(const std::filesystem::path& directory) {
    std::string out;
    for (const std::string name : bundle_names) {
        const auto script = read_file(directory / (name + ".min.js"));
        if (!script) return {};
        const auto licence = read_file(directory / (name + ".LICENSE"));
        out += "<script>\n";
        if (licence) out += "/*! " + name + "\n" + inline_script(*licence) + "*/\n";
        out += inline_script(*script) + "</script>\n";
    }
    return out;
}

}  // namespace edgewise::reports
