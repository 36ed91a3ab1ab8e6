// SPDX-License-Identifier: MIT
//
// A value, or the reason why there is none and a remedy. A value that cannot be measured or read is reported
// as missing; it never becomes a 0.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace edgewise::measure {

template <class Value>
struct Expected;

/// The reason of an Expected without a value, whatever its type.
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
    std::string remedy = {};  ///< what would help, if that is known

    [[nodiscard]] static Expected none(std::string reason, std::string remedy = {}) {
        return {std::nullopt, std::move(reason), std::move(remedy)};
    }
    [[nodiscard]] Refusal refusal() const { return {reason, remedy}; }
};

/// One measured number. If it could not be measured it has no value, but a reason and a remedy; it is never 0
/// and never left out.
struct Figure {
    std::string name;             ///< unique within its probe, e.g. "paper_bytes_per_edge"
    std::optional<double> value;  ///< null: not measured, see reason
    std::string unit;             ///< "B/edge", "ns", "1" ...
    std::string reason = {};      ///< why there is no value
    std::string remedy = {};      ///< what would make it measurable
};

}  // namespace edgewise::measure
