// SPDX-License-Identifier: MIT
//
// Reasons are written from the parts, so that they cannot contradict the numbers.
#include "edgewise/reports/paper/claims/claim_rules.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <tuple>

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

Evidence multiple(const Evidence& of, double factor) {
    if (!of.value) return of;
    return {*of.value * factor, of.low * factor, of.high * factor};
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

namespace {

std::string value_text(const Claim& text, const ClaimPart& part) {
    return fmt::format("{} {}", part.label,
                       evidence_text(part.ours, part.unit.empty() ? text.unit : part.unit));
}

/// Why parts miss, are missing or straddle; the parts that hold give none.
struct Findings {
    std::string missed, straddling;
    bool any_value = false;
    nlohmann::ordered_map<std::string, std::string> missing = {};  ///< reasons, and the parts that share them

    void add(const Claim& text, const ClaimPart& part) {
        const Evidence& ours = part.ours;
        any_value = any_value || ours.value;
        if (!ours.value) {
            append(missing[ours.missing], part.label, "; ");
        } else if (ours.high < part.wanted.low || ours.low > part.wanted.high) {
            append(missed, value_text(text, part) + ", where the rule wants " + part.wanted.description,
                   "; ");
        } else if (ours.low < part.wanted.low || ours.high > part.wanted.high) {
            append(straddling,
                   fmt::format("the interval of {} straddles the rule, {}", value_text(text, part),
                               part.wanted.description),
                   "; ");
        }
    }
    /// One reason for everything needs no list of parts.
    [[nodiscard]] std::string missing_text() const {
        if (missing.size() == 1 && !any_value) return missing.front().first;
        std::string out;
        for (const auto& [reason, labels] : missing)
            append(out, fmt::format("{} ({})", reason, labels), "; ");
        return out;
    }
};

std::string wanted_text(const std::vector<ClaimPart>& parts) {
    std::string out;
    for (const ClaimPart& part : parts)
        if (!part.wanted.description.empty()) append(out, part.label + " " + part.wanted.description, "; ");
    return out;
}

/// A text in one line or in several.
std::string joined_lines(const nlohmann::ordered_json& text) {
    if (text.is_string()) return text;
    return fmt::format("{}", fmt::join(text.get<std::vector<std::string>>(), " "));
}

/// Whole numbers with all their digits, others with six.
std::string bound_text(double bound) {
    return bound == std::floor(bound) ? fmt::format("{:.0f}", bound) : fmt::format("{:g}", bound);
}

void take_verdict(const Findings& findings, Claim& claim) {
    if (!findings.missed.empty()) {
        claim.verdict = "not reproduced";
        claim.reason = "because " + findings.missed;
    } else if (!findings.missing.empty()) {
        claim.verdict = "not measured";
        claim.reason = "because " + findings.missing_text();
    } else if (!findings.straddling.empty()) {
        claim.verdict = "inconclusive";
        claim.reason = findings.straddling;
    } else if (!claim.not_identifiable.empty()) {
        claim.verdict = "consistent, not identifiable";
        claim.reason = claim.not_identifiable;
    } else {
        claim.verdict = "reproduced";
    }
}

}  // namespace

Claim claim_of(const nlohmann::ordered_json& entry) {
    return {
        .id = entry["id"],
        .kind = entry["kind"],
        .section = entry["section"],
        .claim = joined_lines(entry["claim"]),
        .paper = entry["paper"],
        .unit = entry["unit"],
        .not_identifiable = entry.contains("not_identifiable") ? joined_lines(entry["not_identifiable"]) : "",
        .rule = joined_lines(entry["rule"]),
        .deterministic = entry["deterministic"]};
}

WantedBand band_of(const nlohmann::ordered_json& part) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // Name, whether it bounds from below, and whether the bound itself is outside.
    constexpr std::tuple<const char*, bool, bool> bounds[] = {{"at least", true, false},
                                                              {"more than", true, true},
                                                              {"at most", false, false},
                                                              {"less than", false, true}};
    WantedBand band{-infinity, infinity, ""};
    for (const auto& [name, is_low, is_open] : bounds) {
        if (!part.contains(name)) continue;
        const double bound = part[name];
        (is_low ? band.low : band.high) =
            is_open ? std::nextafter(bound, is_low ? infinity : -infinity) : bound;
        band.description = fmt::format("{} {}", name, bound_text(bound));
        return band;
    }
    if (!part.contains("between")) return band;
    const double low = part["between"][0], high = part["between"][1];
    return {low, high, fmt::format("between {} and {}", bound_text(low), bound_text(high))};
}

Claim judge_claim(Claim claim, const std::vector<ClaimPart>& parts) {
    Findings findings;
    for (const ClaimPart& part : parts) {
        findings.add(claim, part);
        if (part.ours.value) append(claim.ours, value_text(claim, part), "; ");
    }
    claim.rule = fmt::format("{} Wanted: {}.", claim.rule, wanted_text(parts));
    take_verdict(findings, claim);
    return claim;
}

Claim judge_variants(const Claim& text, const std::string& assumption,
                     const std::vector<ClaimVariant>& variants) {
    assert(!variants.empty());
    std::vector<Claim> claims;
    for (const ClaimVariant& variant : variants) claims.push_back(judge_claim(text, variant.parts));
    Claim claim = claims.front();
    claim.rule += fmt::format(" Whatever the {}.", assumption);
    claim.ours.clear();
    std::string reasons;
    for (std::size_t i = 0; i < claims.size(); ++i) {
        if (!claims[i].ours.empty())
            append(claim.ours, fmt::format("{}: {}", variants[i].name, claims[i].ours), "; ");
        const std::string& why = claims[i].reason;
        append(
            reasons,
            fmt::format("{} {}{}", variants[i].name, claims[i].verdict, why.empty() ? "" : " (" + why + ")"),
            "; ");
    }
    const auto all_are = [&](const auto& property) {
        return std::ranges::all_of(
            claims, [&](const Claim& one) { return one.*property == claims.front().*property; });
    };
    if (all_are(&Claim::reason) && all_are(&Claim::verdict)) return claim;
    claim.reason = reasons;
    if (all_are(&Claim::verdict)) return claim;
    for (const char* undecided : {"not measured", "inconclusive"}) {
        claim.verdict = undecided;
        if (std::ranges::any_of(claims, [&](const Claim& one) { return one.verdict == undecided; }))
            return claim;
    }
    claim.verdict = "depends on: " + assumption;
    claim.reason = fmt::format("the paper does not name its {}: {}", assumption, reasons);
    return claim;
}

}  // namespace edgewise::reports
