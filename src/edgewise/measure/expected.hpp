// SPDX-License-Identifier: MIT
//
// A value, or why there is none and what to do about it. A value that cannot be measured or read is reported
// as missing; it never becomes a 0.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace edgewise::measure {

template <class Value>
struct Expected;

/// Becomes an Expected of any value.
struct Refusal {
    std::string reason = {}, remedy = {};

    template <class Value>
    operator Expected<Value>() const {
        return {std::nullopt, reason, remedy};
    }
};

template <class Value>
struct Expected {
    std::optional<Value> value;
    std::string reason = {};  ///< why there is no value
    std::string remedy = {};  ///< what would help, where that is known

    [[nodiscard]] static Expected none(std::string reason, std::string remedy = {}) {
        return {std::nullopt, std::move(reason), std::move(remedy)};
    }
    [[nodiscard]] Refusal refusal() const { return {reason, remedy}; }
};

}  // namespace edgewise::measure
