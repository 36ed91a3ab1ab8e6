// SPDX-License-Identifier: MIT
//
// Options that are counts or real numbers, read as plans and scene files read theirs (input/count.hpp). No
// option leaves its number to CLI11, which takes nan, inf, 0x10, ' 5' and '+5'.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edgewise/cli/command.hpp"
#include "edgewise/input/count.hpp"

namespace edgewise::cli {

/// The count, or CLI::ValidationError with the option's name, what was given and what is wanted.
[[nodiscard]] std::uint64_t value_of(const std::string& option, const std::string& text,
                                     const input::CountRange& range);
/// The real number, or CLI::ValidationError likewise.
[[nodiscard]] double value_of(const std::string& option, const std::string& text,
                              const input::NumberRange& range);

inline constexpr const char* type_of(const input::CountRange& /*range*/) { return "COUNT"; }
inline constexpr const char* type_of(const input::NumberRange& /*range*/) { return "NUMBER"; }

template <class Value, class Range>
CLI::Option* add_value(CLI::App& command, const std::string& name, Value& to, const Range& range,
                       const std::string& what) {
    return command
        .add_option_function<std::string>(
            name,
            [&to, name, range](const std::string& text) {
                to = static_cast<Value>(value_of(name, text, range));
            },
            what)
        ->type_name(type_of(range))
        ->default_str(fmt::format("{}", to));
}

template <class Value, class Range>
CLI::Option* add_value(CLI::App& command, const std::string& name, std::optional<Value>& to,
                       const Range& range, const std::string& what) {
    return command
        .add_option_function<std::string>(
            name,
            [&to, name, range](const std::string& text) {
                to = static_cast<Value>(value_of(name, text, range));
            },
            what)
        ->type_name(type_of(range));
}

/// Several, which commas may separate.
template <class Value, class Range>
CLI::Option* add_value(CLI::App& command, const std::string& name, std::vector<Value>& to, const Range& range,
                       const std::string& what) {
    return command
        .add_option_function<std::vector<std::string>>(
            name,
            [&to, name, range](const std::vector<std::string>& texts) {
                to.clear();
                for (const std::string& text : texts)
                    to.push_back(static_cast<Value>(value_of(name, text, range)));
            },
            what)
        ->type_name(type_of(range))
        ->delimiter(',');
}

/// `to`: a whole number, perhaps one (std::optional), or several (std::vector).
template <class To>
CLI::Option* add_count(CLI::App& command, const std::string& name, To& to, const input::CountRange& range,
                       const std::string& what) {
    return add_value(command, name, to, range, what);
}

/// `to`: a double, perhaps one (std::optional), or several (std::vector).
template <class To>
CLI::Option* add_number(CLI::App& command, const std::string& name, To& to, const input::NumberRange& range,
                        const std::string& what) {
    return add_value(command, name, to, range, what);
}

}  // namespace edgewise::cli
