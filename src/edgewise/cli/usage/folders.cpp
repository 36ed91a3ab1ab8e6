// SPDX-License-Identifier: MIT
#include "edgewise/cli/usage/folders.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "edgewise/cli/command.hpp"
#include "edgewise/input/output_file.hpp"

namespace edgewise::cli {

namespace fs = std::filesystem;

namespace {

/// "out/" is "out".
fs::path named_folder(const std::string& folder) {
    const fs::path path = fs::path(folder).lexically_normal();
    return path.has_filename() ? path : path.parent_path();
}

bool is_usual(const std::string& folder) { return folder == folder_of(default_store); }

}  // namespace

CLI::Option* add_output_file(CLI::App& command, const std::string& name, std::string& to,
                             const std::string& what) {
    const auto is_fit = [](const std::string& path) -> std::string {
        try {
            static_cast<void>(input::output_place(path));
            return {};
        } catch (const std::exception& problem) {
            return problem.what();
        }
    };
    return command.add_option(name, to, what)->type_name("FILE")->check(CLI::Validator(is_fit, ""));
}

void check_folder(const std::string& folder, const std::string& option) {
    const fs::path named = named_folder(folder), above = named.parent_path();
    if (fs::is_directory(named)) return;
    if (!above.empty() && !fs::is_directory(above))
        throw std::invalid_argument(fmt::format("{} {}: there is no folder {}; make it, or correct the path",
                                                option, folder, above.string()));
}

void check_folder_of(const std::string& file, const std::string& option) {
    if (!is_usual(folder_of(file))) check_folder(folder_of(file), option);
}

void make_folder(const std::string& folder, const std::string& option) {
    check_folder(folder, option);
    std::error_code failed;
    fs::create_directory(named_folder(folder), failed);
    if (failed)
        throw std::invalid_argument(
            fmt::format("{} {}: the folder cannot be made: {}", option, folder, failed.message()));
}

void make_folder_of(const std::string& file, const std::string& option) {
    const std::string folder = folder_of(file);
    if (is_usual(folder)) fs::create_directories(folder);
    make_folder(folder, option);
}

}  // namespace edgewise::cli
