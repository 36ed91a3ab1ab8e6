// SPDX-License-Identifier: MIT
//
// The claims together: as a summary, as a grid for the report, and as `edgewise report claims` prints them.
#include "edgewise/reports/paper/claims/claims.hpp"

#include <fmt/core.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {
namespace {

using ClaimJson = nlohmann::ordered_json;

std::string claims_json(const ReportData& data, const std::vector<Claim>& claims) {
    ClaimJson all = ClaimJson::array();
    for (const Claim& claim : claims)
        all.push_back({{"id", claim.id},
                       {"kind", claim.kind},
                       {"section", claim.section},
                       {"claim", claim.claim},
                       {"paper", claim.paper},
                       {"ours", claim.ours},
                       {"unit", claim.unit},
                       {"verdict", claim.verdict},
                       {"reason", claim.reason},
                       {"conditions", claim.conditions},
                       {"rule", claim.rule},
                       {"deterministic", claim.deterministic}});
    const ClaimJson machine = input::json_or_null(data.build.machine_json);
    const ClaimJson out = {{"claims", all}, {"machine", machine}};
    return input::json_text(out) + "\n";
}

constexpr const char* not_measured = "not measured";

/// How many claims there is nothing of, which, and what to do. Empty where all were measured.
std::string what_is_missing(const std::vector<Claim>& claims) {
    std::string names;
    std::size_t count = 0;
    for (const Claim& claim : claims) {
        if (claim.verdict != not_measured) continue;
        append(names, claim.id);
        ++count;
    }
    if (count == 0) return {};
    return fmt::format(
        "{} of {} claims were not measured: run layouts/sweep --paper, which asks for what they "
        "want (why each is not: --json). They are: {}\n",
        count, claims.size(), names);
}

std::string seeds_in_words(const ReportData& data) {
    std::set<std::uint64_t> seeds;
    for (const ReportCell* cell : data.swept()) seeds.insert(cell->seed);
    if (seeds.empty()) return "for no seed";
    return fmt::format("for seed{} {}", seeds.size() > 1 ? "s" : "", fmt::join(seeds, ", "));
}

/// Larger than the first level: "L2 2 MiB, L3 480 MiB".
std::string outer_caches(const nlohmann::json& machine) {
    std::string out;
    if (!machine.contains("caches") || !machine["caches"].is_array()) return out;
    for (const nlohmann::json& cache : machine["caches"]) {
        const auto level = input::member_of(cache, "level"), bytes = input::member_of(cache, "bytes");
        if (!level.is_number_unsigned() || !bytes.is_number() || level < 2 || bytes <= 0) continue;
        append(out, fmt::format("L{} {}", level.get<unsigned>(), size_text(bytes.get<double>())));
    }
    return out;
}

std::string machine_of_claims(const ReportData& data) {
    const auto machine = input::json_or_null(data.build.machine_json);
    if (!machine.is_object()) return "not stored";
    std::string out = processor_text(data);
    append(out, outer_caches(machine));
    return out;
}

}  // namespace

std::string claims_summary(const std::vector<Claim>& claims) {
    nlohmann::ordered_map<std::string, std::string> names_by_verdict;  // in the order of the first of each
    for (const Claim& claim : claims)
        if (claim.kind == "primary") append(names_by_verdict[claim.verdict], claim.id);
    std::string out;
    for (const auto& [verdict, names] : names_by_verdict) append(out, verdict + ": " + names, "; ");
    return "Primary findings " + out;
}

/// The summary first, then what is missing; of each claim that was measured a line of short columns, then one
/// for each longer text.
std::string claims_text(const ReportData& data, bool json) {
    const std::vector<Claim> claims = judge_claims(data);
    if (json) return claims_json(data, claims);
    std::size_t id = 0, section = 0;
    for (const Claim& claim : claims) {
        id = std::max(id, claim.id.size());
        section = std::max(section, claim.section.size());
    }
    std::string out = claims_summary(claims) + "\n" + what_is_missing(claims) + "\n";
    out += fmt::format("{:<{}}  {:<10}  {:<{}}  {}\n", "claim", id, "kind", "section", section, "verdict");
    for (const Claim& claim : claims) {
        if (claim.verdict == not_measured) continue;
        out += fmt::format("{:<{}}  {:<10}  {:<{}}  {}\n", claim.id, id, claim.kind, claim.section, section,
                           claim.verdict);
        out += fmt::format("    {}\n    paper: {}\n", claim.claim, claim.paper);
        if (!claim.ours.empty()) out += fmt::format("    here: {}\n", claim.ours);
        if (!claim.reason.empty()) out += fmt::format("    why: {}\n", claim.reason);
        out += fmt::format("    holds: {}\n", claim.conditions);
    }
    return out;
}

measure::FigureRecord claims_record(const ReportData& data) {
    measure::FigureRecord record{"claims", {}, {{"build", data.build.id}}, {}, {}};
    for (const Claim& claim : judge_claims(data))
        record.rows.push_back({.cell = claim.id,
                               .figure = "verdict",
                               .text = claim.verdict,
                               .note = claim.ours + (claim.reason.empty() ? "" : " (" + claim.reason + ")")});
    return record;
}

TextGrid claims_grid(const ReportData& data) {
    const std::vector<Claim> claims = judge_claims(data);
    TextGrid grid{claims_summary(claims),
                  columns_of("kind|section|claim|paper|here, with 95 % intervals|verdict|why|rule|holds")};
    grid.shown_rows = claims.size();
    for (const Claim& claim : claims) {
        const bool measured = claim.verdict != not_measured;
        // Where nothing was measured, a verdict has its number of a footnote, as in every other table.
        grid.add(claim.kind, claim.section, claim.claim, claim.paper, claim.ours,
                 measured ? GridCell{claim.verdict} : missing_cell(claim.reason),
                 measured ? claim.reason : "", claim.rule, claim.conditions);
    }
    return grid;
}

std::string claim_conditions(const ReportData& data, bool deterministic) {
    const std::string seeds = seeds_in_words(data);
    if (deterministic) return seeds + ", on any machine";
    return fmt::format("{}, on this machine: {}; {}", seeds, machine_of_claims(data),
                       data.build.compiler.empty() ? "compiler not stored" : data.build.compiler);
}

}  // namespace edgewise::reports
