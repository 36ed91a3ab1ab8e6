// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "house.hpp"

namespace edgewise::house {

namespace {

/// Returns what is wrong with a line of a file; empty if nothing is.
using LineRule = std::function<std::string(const SourceFile& file, const std::string& line)>;

Violations check_lines(const Files& files, const LineRule& rule) {
    Violations found;
    for (const SourceFile& file : files) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string wrong = rule(file, file.lines[i]);
            if (!wrong.empty()) found.push_back({file.path, i + 1, wrong});
        }
    }
    return found;
}

bool needs_licence(const SourceFile& file) {
    static const std::regex source(R"(.*(\.(hpp|cpp|in|cmake|sh|mjs)|CMakeLists\.txt))");
    return std::regex_match(file.path, source) || (!file.lines.empty() && file.lines[0].starts_with("#!"));
}

/// True if one of the first lines has this text.
bool begins_with(const SourceFile& file, std::size_t lines, const std::string& text) {
    return std::any_of(file.lines.begin(),
                       file.lines.begin() + static_cast<std::ptrdiff_t>(std::min(lines, file.lines.size())),
                       [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

/// Words that name a package host or a folder of one machine. Each has an "@" in the list, so that this file
/// passes its own check.
std::vector<std::string> foreign_words() {
    std::istringstream list(
        "registry@.npm npm@js. deb@.debian archive@.ubuntu py@pi.org crates@.io raw.github@usercontent "
        "jsdel@ivr unp@kg. cdn@js. /ho@me/ /wo@rk/ /ro@ot/ /Us@ers/ C:@\\ /tm@p/");
    std::vector<std::string> words;
    for (std::string word; list >> word;) words.push_back(word.erase(word.find('@'), 1));
    return words;
}

/// Archives, bundles, libraries, meshes: the build fetches them, the tree does not keep them.
std::string foreign_file(const SourceFile& file) {
    static const std::regex fetched(R"(.*\.(deb|tgz|gz|xz|zip|jar|a|so|o|stl|STL|obj|dae|min\.js|exe|db))");
    if (std::regex_match(file.path, fetched)) return "files of this type are fetched, not kept here";
    const bool has_copyright = begins_with(file, 20, std::string("Copy") + "right (");
    return has_copyright && !file.path.ends_with("LICENSE") ? "has a copyright of its own" : "";
}

/// The line on which the block begins that a brace alone in line `end` closes: the nearest line above that is
/// indented no more, with the template line before it.
std::size_t first_line(const std::vector<std::string>& lines, std::size_t end) {
    const std::size_t indentation = lines[end].size() - 1;
    std::size_t at = end;
    while (at > 0) {
        const std::size_t column = lines[--at].find_first_not_of(' ');
        if (column <= indentation && lines[at][column] != '#') break;
    }
    return at > 0 && lines[at - 1].starts_with(std::string(indentation, ' ') + "template <") ? at - 1 : at;
}

/// Every path, and what is left of it without its first folders. A file NAME.in is generated as NAME, and
/// "edgewise/..." is how files are included.
std::set<std::string> ends_of_paths(const Files& files) {
    std::set<std::string> ends;
    for (const SourceFile& file : files) {
        std::string path = "edgewise/" + file.path;
        if (path.ends_with(".in")) path.resize(path.size() - 3);
        ends.insert(path);
        for (std::size_t slash; (slash = path.find('/')) != std::string::npos; ends.insert(path))
            path = path.substr(slash + 1);
    }
    return ends;
}

}  // namespace

Violations missing_licences(const Files& files) {
    Violations found;
    for (const SourceFile& file : files) {
        if (needs_licence(file) && !begins_with(file, 3, "SPDX-License-Identifier: MIT"))
            found.push_back({file.path, 1, "the first lines lack SPDX-License-Identifier: MIT"});
    }
    return found;
}

Violations long_files(const Files& files) {
    Violations found;
    for (const SourceFile& file : files) {
        if (needs_licence(file) && file.lines.size() > longest_file)
            found.push_back({file.path, 0, std::to_string(file.lines.size()) + " lines"});
    }
    return found;
}

Violations functions_beyond(std::size_t longest, const Files& files) {
    Violations found;
    for (const SourceFile& file : files) {
        for (std::size_t end = 0; is_cpp(file) && end < file.lines.size(); ++end) {
            if (file.lines[end].find_first_not_of(' ') != file.lines[end].find('}') ||
                !file.lines[end].ends_with('}'))
                continue;
            const std::size_t first = first_line(file.lines, end), length = end - first + 1;
            if (length > longest)
                found.push_back({file.path, first + 1, "a function of " + std::to_string(length) + " lines"});
        }
    }
    return found;
}

Violations long_functions(const Files& files) { return functions_beyond(longest_function, files); }

Violations foreign_matter(const Files& files) {
    const std::vector<std::string> words = foreign_words();
    Violations found = check_lines(files, [&](const SourceFile&, const std::string& line) {
        for (const std::string& word : words)
            if (line.find(word) != std::string::npos)
                return "names a package host or a folder of one machine: " + word;
        return std::string();
    });
    for (const SourceFile& file : files) {
        if (const std::string what = foreign_file(file); !what.empty()) found.push_back({file.path, 0, what});
    }
    return found;
}

Violations types_named_twice(const Files& files) {
    static const std::regex opens(R"(^namespace (\S+) \{.*)");
    static const std::regex defines(R"(^(?:struct|class|union|enum(?: class)?) (\w+)(?![\w<])[^;]*$)");
    std::map<std::string, std::string> places;  // of namespace::name
    std::string inside;
    return check_lines(files, [&](const SourceFile& file, const std::string& line) -> std::string {
        if (!file.path.ends_with(".hpp") || file.path.starts_with("tests/")) return "";
        std::smatch match;
        if (std::regex_match(line, match, opens)) inside = match[1];
        if (!std::regex_match(line, match, defines)) return "";
        const std::string name = inside + "::" + match[1].str();
        const auto [place, is_new] = places.emplace(name, file.path);
        return is_new ? "" : name + " is also in " + place->second;
    });
}

Violations own_flattening(const Files& files) {
    static const std::regex attribute(R"((__attribute__\(\(|\[\[).*\b(flatten|no_sanitize)\b)");
    return check_lines(files, [](const SourceFile& file, const std::string& line) {
        const bool is_checked = is_cpp(file) && !file.path.ends_with("geometry/inlining.hpp");
        return is_checked && std::regex_search(line, attribute)
                   ? "flatten or no_sanitize: use a macro of geometry/inlining.hpp"
                   : "";
    });
}

Violations dead_mentions(const Files& files) {
    static const std::regex name(R"((?:\.\./)*((?:\w[\w.-]*/)*\w+\.[hc]pp)\b)");
    return check_lines(
        files, [there = ends_of_paths(files)](const SourceFile& file, const std::string& line) {
            const bool is_cmake = file.path.ends_with(".cmake") || file.path.ends_with("CMakeLists.txt");
            const std::size_t mark = is_cpp(file) ? line.find("//")
                                     : is_cmake   ? line.find('#')
                                                  : std::string::npos;
            if (mark == std::string::npos) return std::string();
            const std::string comment = line.substr(mark);
            for (std::sregex_iterator at(comment.begin(), comment.end(), name), end; at != end; ++at) {
                const std::string path = (*at)[1];
                // A capital is a placeholder, as in NAME.hpp.
                const bool is_name = std::islower(static_cast<unsigned char>(path[path.rfind('/') + 1])) != 0;
                if (is_name && !there.contains(path)) return "there is no " + path;
            }
            return std::string();
        });
}

Violations long_readme(const Files& files) {
    Violations found;
    for (const SourceFile& file : files) {
        if (file.path != "README.md") continue;
        std::size_t words = 0;
        for (const std::string& line : file.lines) {
            std::istringstream stream(line);
            words += static_cast<std::size_t>(std::distance(std::istream_iterator<std::string>(stream),
                                                            std::istream_iterator<std::string>()));
        }
        if (words > readme_words) found.push_back({file.path, 0, std::to_string(words) + " words"});
    }
    return found;
}

}  // namespace edgewise::house
