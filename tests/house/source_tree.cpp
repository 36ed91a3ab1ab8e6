// SPDX-License-Identifier: MIT
#include <algorithm>
#include <fstream>
#include <sstream>

#include "house.hpp"

namespace edgewise::house {

namespace {

namespace fs = std::filesystem;

/// True of what .gitignore names, and of git's own folder.
bool is_left_behind(const std::string& path) {
    return path == "build" || path == ".git" || path == "reports/out" || path.ends_with(".deb");
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

}  // namespace

SourceFile source_file(std::string path, const std::string& text) {
    SourceFile file{std::move(path), {}};
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
    return file;
}

Files read_tree(const fs::path& root) {
    Files files;
    for (auto at = fs::recursive_directory_iterator(root); at != fs::recursive_directory_iterator(); ++at) {
        const std::string path = fs::relative(at->path(), root).generic_string();
        if (is_left_behind(path)) {
            if (at->is_directory()) at.disable_recursion_pending();
        } else if (at->is_regular_file()) {
            files.push_back(source_file(path, text_of(at->path())));
        }
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return files;
}

bool is_cpp(const SourceFile& file) { return file.path.ends_with(".hpp") || file.path.ends_with(".cpp"); }

std::string to_text(const Violations& violations) {
    std::ostringstream text;
    for (const Violation& v : violations) text << v.file << ":" << v.line << ": " << v.what << "\n";
    return text.str();
}

}  // namespace edgewise::house
