// SPDX-License-Identifier: MIT
#include "text_rules.hpp"

#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "function_spans.hpp"

namespace edgewise::house {

namespace {

/// What follows the first mark of a comment; "" where a line has none.
std::string comment_of(const SourceFile& file, const std::string& line) {
    const std::string mark = is_cpp(file) ? "//" : "#";
    const auto at = line.find(mark);
    return at == std::string::npos ? "" : line.substr(at + mark.size());
}

bool has_comments(const SourceFile& file) {
    return is_cpp(file) || file.path.ends_with(".cmake") || file.path.ends_with("CMakeLists.txt");
}

/// Every path, and what is left of it without its first folders. A file NAME.in is generated as NAME, and
/// "edgewise/..." is how files are included.
std::set<std::string> ends_of_paths(const std::vector<SourceFile>& files) {
    std::set<std::string> ends;
    for (const SourceFile& file : files) {
        std::string path = "edgewise/" + file.path;
        if (path.ends_with(".in")) path.resize(path.size() - 3);
        for (;;) {
            ends.insert(path);
            const auto slash = path.find('/');
            if (slash == std::string::npos) break;
            path = path.substr(slash + 1);
        }
    }
    return ends;
}

}  // namespace

std::vector<Violation> own_flattening(const std::vector<SourceFile>& files) {
    static const std::regex attribute(R"((__attribute__\(\(|\[\[).*\b(flatten|no_sanitize)\b)");
    std::vector<Violation> found;
    for (const SourceFile& file : files) {
        if (!is_cpp(file) || file.path.ends_with("geometry/inlining.hpp")) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            if (std::regex_search(file.lines[i], attribute))
                found.push_back({file.path, i + 1, "flatten or no_sanitize: use EDGEWISE_QUERY_LOOP"});
        }
    }
    return found;
}

std::vector<Violation> dead_mentions(const std::vector<SourceFile>& files) {
    static const std::regex name(R"((?:\.\./)*((?:\w[\w.-]*/)*\w+\.[hc]pp)\b)");
    const std::set<std::string> there = ends_of_paths(files);
    std::vector<Violation> found;
    for (const SourceFile& file : files) {
        if (!has_comments(file)) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string comment = comment_of(file, file.lines[i]);
            for (std::sregex_iterator at(comment.begin(), comment.end(), name), end; at != end; ++at) {
                const std::string path = (*at)[1];
                const char initial = path[path.rfind('/') + 1];
                const bool is_pattern = !std::islower(static_cast<unsigned char>(initial));  // as NAME.hpp is
                if (!is_pattern && !there.contains(path))
                    found.push_back({file.path, i + 1, "there is no " + path});
            }
        }
    }
    return found;
}

std::vector<Violation> long_readme(const std::vector<SourceFile>& files) {
    std::vector<Violation> found;
    for (const SourceFile& file : files) {
        if (file.path != "README.md") continue;
        std::size_t words = 0;
        for (const std::string& line : file.lines) {
            std::istringstream stream(line);
            for (std::string word; stream >> word;) ++words;
        }
        if (file.lines.size() > readme_lines)
            found.push_back({file.path, 0, std::to_string(file.lines.size()) + " lines"});
        if (words > readme_words) found.push_back({file.path, 0, std::to_string(words) + " words"});
    }
    return found;
}

std::vector<Violation> long_classes(const std::vector<SourceFile>& files) {
    std::vector<Violation> found;
    for (const SourceFile& file : files) {
        if (!is_cpp(file)) continue;
        for (const Span& span : class_spans(file.lines)) {
            const std::size_t length = span.last - span.first + 1;
            if (length > longest_class)
                found.push_back({file.path, span.first, "a class of " + std::to_string(length) + " lines"});
        }
    }
    return found;
}

}  // namespace edgewise::house
