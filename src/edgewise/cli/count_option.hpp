// SPDX-License-Identifier: MIT
//
// Options that are counts, read as plans and scene files read theirs (input/count.hpp).
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/cli/command.hpp"
#include "edgewise/input/count.hpp"

namespace edgewise::cli {

/// The count, or CLI::ValidationError with the option's name, what was given and what is wanted.
[[nodiscard]] std::uint64_t count_of(const std::string& option, const std::string& text,
                                     const input::CountRange& range);

inline constexpr const char* count_type = "COUNT";

template <std::integral Whole>
CLI::Option* add_count(CLI::App& command, const std::string& name, Whole& to, const input::CountRange& range,
                       const std::string& what) {
    return command
        .add_option_function<std::string>(
            name,
            [&to, name, range](const std::string& text) {
                to = static_cast<Whole>(count_of(name, text, range));
            },
            what)
        ->type_name(count_type)
        ->default_str(std::to_string(to));
}

template <std::integral Whole>
CLI::Option* add_count(CLI::App& command, const std::string& name, std::optional<Whole>& to,
                       const input::CountRange& range, const std::string& what) {
    return command
        .add_option_function<std::string>(
            name,
            [&to, name, range](const std::string& text) {
                to = static_cast<Whole>(count_of(name, text, range));
            },
            what)
        ->type_name(count_type);
}

/// Several, which commas may separate.
template <std::integral Whole>
CLI::Option* add_counts(CLI::App& command, const std::string& name, std::vector<Whole>& to,
                        const input::CountRange& range, const std::string& what) {
    return command
        .add_option_function<std::vector<std::string>>(
            name,
            [&to, name, range](const std::vector<std::string>& texts) {
                to.clear();
                for (const std::string& text : texts)
                    to.push_back(static_cast<Whole>(count_of(name, text, range)));
            },
            what)
        ->type_name(count_type)
        ->delimiter(',');
}

}  // namespace edgewise::cli
