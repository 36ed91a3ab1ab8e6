// SPDX-License-Identifier: MIT
//
// See claim_rules.hpp. Reasons are written from the parts, so that they cannot contradict the numbers.
#include "edgewise/reports/paper/claims/claim_rules.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <utility>

namespace edgewise::reports {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Whole numbers with all their digits, others with six.
std::string bound_text(double bound) {
    return bound == std::floor(bound) ? fmt::format("{:.0f}", bound) : fmt::format("{:g}", bound);
}

std::string joined(const std::string& a, const std::string& b) { return a.empty() ? b : a + "; " + b; }

std::string value_text(const ClaimText& text, const ClaimPart& part) {
    return fmt::format("{} {}", part.label,
                       evidence_text(part.ours, part.unit.empty() ? text.unit : part.unit));
}

/// Why parts miss, are missing or straddle; the parts that hold give none.
struct Findings {
    std::string missed, straddling;
    bool any_value = false;
    std::vector<std::pair<std::string, std::string>> missing;  ///< reasons, and the parts that share them

    void add(const ClaimText& text, const ClaimPart& part) {
        const Evidence& ours = part.ours;
        any_value = any_value || ours.value;
        if (!ours.value) {
            add_missing(part.label, ours.missing);
        } else if (ours.high < part.wanted.low || ours.low > part.wanted.high) {
            missed = joined(missed, value_text(text, part) + ", where the rule wants " + part.wanted.words);
        } else if (ours.low < part.wanted.low || ours.high > part.wanted.high) {
            straddling = joined(straddling, fmt::format("the interval of {} straddles the rule, {}",
                                                        value_text(text, part), part.wanted.words));
        }
    }
    void add_missing(const std::string& label, const std::string& reason) {
        for (auto& [known, labels] : missing)
            if (known == reason) return void(labels += "; " + label);
        missing.emplace_back(reason, label);
    }
    /// One reason for everything needs no list of parts.
    [[nodiscard]] std::string missing_text() const {
        if (missing.size() == 1 && !any_value) return missing.front().first;
        std::string out;
        for (const auto& [reason, labels] : missing)
            out = joined(out, fmt::format("{} ({})", reason, labels));
        return out;
    }
};

std::string wanted_text(const std::vector<ClaimPart>& parts) {
    std::string out;
    for (const ClaimPart& part : parts)
        if (!part.wanted.words.empty()) out = joined(out, part.label + " " + part.wanted.words);
    return out;
}

Claim without_verdict(const ClaimText& text) {
    return {text.id,   text.section, text.claim, text.paper, "",
            text.unit, "",           "",         text.rule,  text.deterministic};
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
    } else {
        claim.verdict = "reproduced";
    }
}

std::string of_reading(const TimeStepReading& reading, const Claim& claim) {
    return fmt::format("{} {}{}", reading.words, claim.verdict,
                       claim.reason.empty() ? "" : " (" + claim.reason + ")");
}

}  // namespace

WantedBand at_least(double bound) { return {bound, infinity, "at least " + bound_text(bound)}; }
WantedBand at_most(double bound) { return {-infinity, bound, "at most " + bound_text(bound)}; }
WantedBand more_than(double bound) {
    return {std::nextafter(bound, infinity), infinity, "more than " + bound_text(bound)};
}
WantedBand less_than(double bound) {
    return {-infinity, std::nextafter(bound, -infinity), "less than " + bound_text(bound)};
}
WantedBand between(double low, double high) {
    return {low, high, fmt::format("between {} and {}", bound_text(low), bound_text(high))};
}
WantedBand only_shown() { return {-infinity, infinity, ""}; }

Claim judge_claim(const ClaimText& text, const std::vector<ClaimPart>& parts) {
    Claim claim = without_verdict(text);
    Findings findings;
    for (const ClaimPart& part : parts) {
        findings.add(text, part);
        if (part.ours.value) claim.ours = joined(claim.ours, value_text(text, part));
    }
    claim.rule = fmt::format("{} Wanted: {}.", text.rule, wanted_text(parts));
    take_verdict(findings, claim);
    return claim;
}

Claim judge_readings(const ClaimText& text, const std::vector<ClaimPart>& at_60th,
                     const std::vector<ClaimPart>& at_half) {
    const Claim fast = judge_claim(text, at_60th), slow = judge_claim(text, at_half);
    Claim claim = fast;
    claim.rule += " Both readings of the time step, 1/60 s and 1/2 s, must agree.";
    claim.ours.clear();
    if (!fast.ours.empty()) claim.ours = fmt::format("{}: {}", reading_60th.words, fast.ours);
    if (!slow.ours.empty())
        claim.ours = joined(claim.ours, fmt::format("{}: {}", reading_half.words, slow.ours));
    if (fast.verdict == "reproduced" && slow.verdict == "reproduced") return claim;
    if (fast.reason == slow.reason) return claim;
    claim.reason = of_reading(reading_60th, fast) + "; " + of_reading(reading_half, slow);
    if (fast.verdict == slow.verdict) return claim;
    const bool unmeasured = fast.verdict == "not measured" || slow.verdict == "not measured";
    claim.verdict = unmeasured ? "not measured" : "inconclusive";
    if (!unmeasured)
        claim.reason = "depends on the time step, which the paper does not name: " + claim.reason;
    return claim;
}

}  // namespace edgewise::reports
