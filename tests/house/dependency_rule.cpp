// SPDX-License-Identifier: MIT
#include "dependency_rule.hpp"

#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

namespace edgewise::house {

namespace {

const std::set<std::string> src_rooms = {"geometry", "input", "table",   "layout_parts", "algorithms",
                                         "peers",    "truth", "scene",   "measure",      "store",
                                         "bench",    "sweep", "studies", "cli"};
const std::set<std::string> root_rooms = {"layouts", "probes", "reports"};

/// Direct edges as designed.
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
    if (found == direct_edges.end()) return false;
    for (const std::string& next : found->second) {
        if (may_include(next, to)) return true;
    }
    return false;
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

std::vector<std::string> parts_of(const std::string& path) {
    std::vector<std::string> parts;
    std::istringstream stream(path);
    for (std::string part; std::getline(stream, part, '/');) parts.push_back(part);
    return parts;
}

/// Of a file of the tree; nothing for files outside the rooms.
std::optional<std::string> room_of(const std::string& path) {
    const auto parts = parts_of(path);
    if (parts.size() > 3 && parts[0] == "src") return parts[2];
    if (parts.size() > 1 && root_rooms.contains(parts[0])) return parts[0];
    return std::nullopt;
}

/// "edgewise/table/ring.hpp" -> "src/edgewise/table/ring.hpp".
std::string path_of_include(const std::string& name) {
    const auto parts = parts_of(name);
    const bool at_root = parts.size() > 1 && root_rooms.contains(parts[1]);
    return at_root ? name.substr(std::string("edgewise/").size()) : "src/" + name;
}

std::string what_is_wrong(const std::string& room, const Include& include) {
    if (!include.name.starts_with("edgewise/")) {
        return include.quoted ? "\"" + include.name + "\" must be written \"edgewise/<room>/<file>\"" : "";
    }
    const auto parts = parts_of(include.name);
    const std::string to = parts.size() > 2 ? parts[1] : "";
    if (!src_rooms.contains(to) && !root_rooms.contains(to)) return "there is no room '" + to + "'";
    return may_include(room, to) ? "" : room + " may not include " + to + " (" + include.name + ")";
}

class CycleSearch {
  public:
    explicit CycleSearch(const std::vector<SourceFile>& files) {
        for (const SourceFile& file : files) {
            if (is_cpp(file) && room_of(file.path)) files_[file.path] = &file;
        }
    }

    std::vector<Violation> run() {
        for (const auto& [path, file] : files_) visit(*file);
        return found_;
    }

  private:
    void visit(const SourceFile& file) {
        if (!begun_.insert(file.path).second) return;
        for (const Include& include : includes_of(file)) {
            if (!include.name.starts_with("edgewise/")) continue;
            const auto next = files_.find(path_of_include(include.name));
            if (next == files_.end()) continue;
            const bool on_the_way = begun_.contains(next->first) && !done_.contains(next->first);
            if (on_the_way)
                found_.push_back({file.path, include.line, "includes itself through " + include.name});
            visit(*next->second);
        }
        done_.insert(file.path);
    }

    std::map<std::string, const SourceFile*> files_;
    std::set<std::string> begun_, done_;
    std::vector<Violation> found_;
};

}  // namespace

std::vector<Violation> forbidden_includes(const std::vector<SourceFile>& files) {
    std::vector<Violation> found;
    for (const SourceFile& file : files) {
        const auto room = room_of(file.path);
        if (!room || !is_cpp(file)) continue;
        for (const Include& include : includes_of(file)) {
            const std::string wrong = what_is_wrong(*room, include);
            if (!wrong.empty()) found.push_back({file.path, include.line, wrong});
        }
    }
    return found;
}

std::vector<Violation> include_cycles(const std::vector<SourceFile>& files) {
    return CycleSearch(files).run();
}

}  // namespace edgewise::house
