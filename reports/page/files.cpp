// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/files.hpp"

#include <fmt/core.h>

#include <cctype>
#include <cstdint>
#include <fstream>
#include <sstream>

#include "edgewise/input/output_file.hpp"

namespace edgewise::reports {

namespace {

/// FNV-1a.
std::string hash_of(const std::string& text) {
    std::uint32_t hash = 0x811c9dc5;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193;
    return fmt::format("{:08x}", hash);
}

}  // namespace

std::string file_name_of(std::string name) {
    constexpr std::size_t longest = 100;
    const std::string hash = hash_of(name);
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
    return name.size() <= longest ? name : name.substr(0, longest) + "-" + hash;
}

std::string file_name_of(const std::string& name, const std::set<std::string>& taken) {
    const std::string file = file_name_of(name);
    return taken.contains(file) ? file_name_of(file + "-" + hash_of(name)) : file;
}

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
