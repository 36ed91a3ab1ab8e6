// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/claims/evidence.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

/// The first that is missing, or a reason for none at all; null when all are there.
std::optional<Evidence> what_is_missing(const std::vector<Evidence>& all, const std::string& when_none) {
    if (all.empty()) return no_evidence(when_none);
    const auto gap = std::ranges::find_if(all, [](const Evidence& evidence) { return !evidence.value; });
    if (gap == all.end()) return std::nullopt;
    return *gap;
}

/// Smallest or largest of the values, and of each end of their intervals.
template <class Pick>
Evidence extreme(const std::vector<Evidence>& all, const std::string& when_none, Pick pick) {
    if (const auto gap = what_is_missing(all, when_none)) return *gap;
    Evidence most = all.front();
    for (const Evidence& one : all)
        most = {pick(*most.value, *one.value), pick(most.low, one.low), pick(most.high, one.high)};
    return most;
}

}  // namespace

Evidence exact_evidence(double value) { return {value, value, value}; }

Evidence interval_evidence(double value, double low, double high) {
    return {value, std::min(low, value), std::max(high, value)};
}

Evidence no_evidence(const std::string& why) {
    return {std::nullopt, 0, 0, why.empty() ? "no reason is stored" : why};
}

Evidence quotient(const Evidence& a, const Evidence& b) {
    if (!a.value) return a;
    if (!b.value) return b;
    if (!(b.low > 0) || !(a.low >= 0)) return no_evidence("a divisor of 0 gives no ratio");
    return interval_evidence(*a.value / *b.value, a.low / b.high, a.high / b.low);
}

Evidence sum(const Evidence& a, const Evidence& b) {
    if (!a.value) return a;
    if (!b.value) return b;
    return {*a.value + *b.value, a.low + b.low, a.high + b.high};
}

Evidence no_less_than(Evidence a, double least) {
    if (!a.value) return a;
    return {std::max(*a.value, least), std::max(a.low, least), std::max(a.high, least)};
}

Evidence geometric_mean(const std::vector<Evidence>& all, const std::string& when_none) {
    if (const auto gap = what_is_missing(all, when_none)) return *gap;
    double value = 0, low = 0, high = 0;
    for (const Evidence& one : all) {
        if (!(one.low > 0)) return no_evidence("a value of 0 has no logarithm");
        value += std::log(*one.value);
        low += std::log(one.low);
        high += std::log(one.high);
    }
    const auto n = static_cast<double>(all.size());
    return interval_evidence(std::exp(value / n), std::exp(low / n), std::exp(high / n));
}

Evidence smallest(const std::vector<Evidence>& all, const std::string& when_none) {
    return extreme(all, when_none, [](double a, double b) { return std::min(a, b); });
}

Evidence largest(const std::vector<Evidence>& all, const std::string& when_none) {
    return extreme(all, when_none, [](double a, double b) { return std::max(a, b); });
}

std::string evidence_text(const Evidence& evidence, const std::string& unit) {
    if (!evidence.value) return "not measured";
    std::string text = number_text(*evidence.value, unit);
    if (evidence.has_interval())
        text += fmt::format(" [{}, {}]", number_text(evidence.low, unit), number_text(evidence.high, unit));
    return unit == "1" || unit.empty() ? text : text + " " + unit;
}

}  // namespace edgewise::reports
