// SPDX-License-Identifier: MIT
//
// A figure that was measured, or why there is none and what to do about it. What cannot be measured is said
// so; it never becomes a 0.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace edgewise::measure {

struct Refusal {
    std::string reason, remedy;
};

template <class Value>
struct Measured {
    std::optional<Value> value;
    Refusal refusal = {};  ///< when there is no value

    [[nodiscard]] static Measured refused(std::string reason, std::string remedy) {
        return {std::nullopt, {std::move(reason), std::move(remedy)}};
    }
};

}  // namespace edgewise::measure
