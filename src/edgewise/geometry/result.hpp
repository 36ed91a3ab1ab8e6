// SPDX-License-Identifier: MIT
//
// A value, or one clear line that says why there is none. For errors in data; programmer errors assert.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace edgewise {

template <class Value>
struct Result {
    std::optional<Value> value;
    std::string error;    ///< empty when there is a value; else one line: what, where, what to do
    std::string warning;  ///< the value is valid, but the user should know this

    [[nodiscard]] explicit operator bool() const { return value.has_value(); }
    [[nodiscard]] const Value& operator*() const& { return *value; }
    [[nodiscard]] Value& operator*() & { return *value; }
    [[nodiscard]] Value&& operator*() && { return *std::move(value); }
    [[nodiscard]] const Value* operator->() const { return &*value; }

    /// Returns the value, or throws std::invalid_argument with the error: for files and the command line.
    [[nodiscard]] Value or_throw() && {
        if (!value) throw std::invalid_argument(error);
        return std::move(*value);
    }

    [[nodiscard]] static Result failure(std::string why) { return {std::nullopt, std::move(why), {}}; }
    [[nodiscard]] static Result success(Value v, std::string warning = {}) {
        return {std::move(v), {}, std::move(warning)};
    }
};

}  // namespace edgewise
