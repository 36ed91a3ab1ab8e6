// SPDX-License-Identifier: MIT
#include "file_rules.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <string_view>

#include "function_spans.hpp"

namespace edgewise::house {

namespace {

bool contains(std::string_view text, std::string_view what) {
    return text.find(what) != std::string_view::npos;
}

std::string name_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

bool wants_licence(const SourceFile& file) {
    for (const char* end : {".hpp", ".cpp", ".in", ".cmake", ".sh", ".mjs", "CMakeLists.txt"}) {
        if (file.path.ends_with(end)) return true;
    }
    return !file.lines.empty() && file.lines[0].starts_with("#!");
}

/// Written in two halves, so that this file passes its own check.
const std::array<std::string, 16> foreign_words = {std::string("registry") + ".npm",
                                                   std::string("npm") + "js.",
                                                   std::string("deb") + ".debian",
                                                   std::string("archive") + ".ubuntu",
                                                   std::string("py") + "pi.org",
                                                   std::string("crates") + ".io",
                                                   std::string("raw.github") + "usercontent",
                                                   std::string("jsdel") + "ivr",
                                                   std::string("unp") + "kg.",
                                                   std::string("cdn") + "js.",
                                                   std::string("/ho") + "me/",
                                                   std::string("/wo") + "rk/",
                                                   std::string("/ro") + "ot/",
                                                   std::string("/Us") + "ers/",
                                                   std::string("C:") + "\\",
                                                   std::string("/tm") + "p/"};

/// Archives, bundles, libraries, meshes: what is fetched, never kept.
constexpr std::array fetched_types = {".deb", ".tgz", ".gz",  ".xz",  ".zip", ".jar",    ".a",   ".so",
                                      ".o",   ".stl", ".STL", ".obj", ".dae", ".min.js", ".exe", ".db"};

std::string foreign_in(const std::string& line) {
    for (const std::string& word : foreign_words) {
        if (contains(line, word)) return "names a package host or a folder of one machine: " + word;
    }
    return {};
}

std::string foreign_file(const SourceFile& file) {
    for (const char* type : fetched_types) {
        if (file.path.ends_with(type)) return std::string("third-party matter is not kept here: ") + type;
    }
    const std::string copyright = std::string("Copy") + "right (";
    const auto top =
        file.lines.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(file.lines.size(), 20));
    const bool bears_copyright = std::any_of(
        file.lines.begin(), top, [&](const std::string& line) { return contains(line, copyright); });
    return bears_copyright && name_of(file.path) != "LICENSE" ? "bears a copyright of its own" : "";
}

}  // namespace

std::vector<Violation> missing_licences(const std::vector<SourceFile>& files) {
    std::vector<Violation> found;
    for (const SourceFile& file : files) {
        if (!wants_licence(file)) continue;
        const auto top =
            file.lines.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(file.lines.size(), 3));
        const bool there = std::any_of(file.lines.begin(), top, [](const std::string& line) {
            return contains(line, "SPDX-License-Identifier: MIT");
        });
        if (!there) found.push_back({file.path, 1, "the first lines lack SPDX-License-Identifier: MIT"});
    }
    return found;
}

std::vector<Violation> long_files(const std::vector<SourceFile>& files) {
    std::vector<Violation> found;
    for (const SourceFile& file : files) {
        if (!wants_licence(file) || file.lines.size() <= longest_file) continue;
        found.push_back({file.path, 0, std::to_string(file.lines.size()) + " lines"});
    }
    return found;
}

std::vector<Violation> long_functions(const std::vector<SourceFile>& files) {
    std::vector<Violation> found;
    for (const SourceFile& file : files) {
        if (!is_cpp(file)) continue;
        for (const Span& span : function_spans(file.lines)) {
            const std::size_t length = span.last - span.first + 1;
            if (length > longest_function) {
                found.push_back(
                    {file.path, span.first, "a function of " + std::to_string(length) + " lines"});
            }
        }
    }
    return found;
}

std::vector<Violation> foreign_matter(const std::vector<SourceFile>& files) {
    std::vector<Violation> found;
    for (const SourceFile& file : files) {
        if (const std::string what = foreign_file(file); !what.empty()) found.push_back({file.path, 0, what});
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string what = foreign_in(file.lines[i]);
            if (!what.empty()) found.push_back({file.path, i + 1, what});
        }
    }
    return found;
}

std::vector<Violation> types_named_twice(const std::vector<SourceFile>& files) {
    static const std::regex opens(R"(^namespace (\S+) \{.*)");
    static const std::regex defines(R"(^(?:struct|class|union|enum(?: class)?) (\w+)(?![\w<])[^;]*$)");
    std::vector<Violation> found;
    std::map<std::string, std::string> places;  // of namespace::name
    for (const SourceFile& file : files) {
        if (!file.path.ends_with(".hpp") || file.path.starts_with("tests/")) continue;
        std::string inside;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            std::smatch match;
            if (std::regex_match(file.lines[i], match, opens)) inside = match[1];
            if (!std::regex_match(file.lines[i], match, defines)) continue;
            const std::string name = inside + "::" + match[1].str();
            const auto [place, is_new] = places.emplace(name, file.path);
            if (!is_new) found.push_back({file.path, i + 1, name + " is also in " + place->second});
        }
    }
    return found;
}

}  // namespace edgewise::house
