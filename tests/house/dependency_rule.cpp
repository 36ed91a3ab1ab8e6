// SPDX-License-Identifier: MIT
#include <functional>
#include <map>
#include <regex>
#include <set>

#include "house.hpp"

namespace edgewise::house {

namespace {

/// The rooms that each room includes directly, as designed.
const std::map<std::string, std::set<std::string>> direct_edges = {
    {"geometry", {}},
    {"input", {"geometry"}},
    {"table", {"geometry"}},
    {"layout_parts", {"table"}},
    {"layouts", {"layout_parts"}},
    {"algorithms", {"table"}},
    {"truth", {"geometry"}},
    {"scene", {"algorithms", "input", "truth"}},
    {"measure", {"input"}},
    {"store", {"measure"}},
    {"peers", {"geometry"}},
    {"bench", {"scene", "store", "layout_parts", "peers"}},
    {"probes", {"bench"}},
    {"sweep", {"bench"}},
    {"studies", {"sweep"}},
    {"reports", {"store"}},
    {"cli", {"studies", "reports"}},
};

bool may_include(const std::string& from, const std::string& to) {
    if (from == to) return true;
    const auto found = direct_edges.find(from);
    return found != direct_edges.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [&](const std::string& next) { return may_include(next, to); });
}

struct Include {
    std::string name;
    std::size_t line;
    bool quoted;
};

std::vector<Include> includes_of(const SourceFile& file) {
    static const std::regex directive(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    std::vector<Include> includes;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        std::smatch match;
        if (std::regex_match(file.lines[i], match, directive))
            includes.push_back({match[2], i + 1, match[1] == "\""});
    }
    return includes;
}

/// "src/edgewise/table/ring.hpp" -> "edgewise/table/ring.hpp"; "layouts/aos.hpp" ->
/// "edgewise/layouts/aos.hpp".
std::string include_name(const SourceFile& file) {
    return file.path.starts_with("src/") ? file.path.substr(4) : "edgewise/" + file.path;
}

/// The room in "edgewise/<room>/<file>"; empty if the name has no room.
std::string room_in(const std::string& name) {
    static const std::regex in_room("edgewise/([^/]+)/.+");
    std::smatch match;
    return std::regex_match(name, match, in_room) ? match[1].str() : "";
}

/// The room of a C++ file; empty for other files, and for files outside the rooms.
std::string room_of(const SourceFile& file) {
    const std::string room = room_in(include_name(file));
    return is_cpp(file) && (file.path.starts_with("src/") || direct_edges.contains(room)) ? room : "";
}

std::string what_is_wrong(const std::string& room, const Include& include) {
    if (!include.name.starts_with("edgewise/"))
        return include.quoted ? "\"" + include.name + "\" must be written \"edgewise/<room>/<file>\"" : "";
    const std::string to = room_in(include.name);
    if (!direct_edges.contains(to)) return "there is no room '" + to + "'";
    return may_include(room, to) ? "" : room + " may not include " + to + " (" + include.name + ")";
}

}  // namespace

Violations forbidden_includes(const Files& files) {
    Violations found;
    for (const SourceFile& file : files) {
        const std::string room = room_of(file);
        if (room.empty()) continue;
        for (const Include& include : includes_of(file)) {
            const std::string wrong = what_is_wrong(room, include);
            if (!wrong.empty()) found.push_back({file.path, include.line, wrong});
        }
    }
    return found;
}

Violations include_cycles(const Files& files) {
    std::map<std::string, const SourceFile*> by_name;
    for (const SourceFile& file : files)
        if (!room_of(file).empty()) by_name[include_name(file)] = &file;
    Violations found;
    std::set<const SourceFile*> begun, done;
    const std::function<void(const SourceFile*)> visit = [&](const SourceFile* file) {
        if (!begun.insert(file).second) return;
        for (const Include& include : includes_of(*file)) {
            const auto next = by_name.find(include.name);
            if (next == by_name.end()) continue;
            if (begun.contains(next->second) && !done.contains(next->second))
                found.push_back({file->path, include.line, "includes itself through " + include.name});
            visit(next->second);
        }
        done.insert(file);
    };
    for (const auto& [name, file] : by_name) visit(file);
    return found;
}

}  // namespace edgewise::house
