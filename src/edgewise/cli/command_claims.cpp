// SPDX-License-Identifier: MIT
//
// `edgewise claims`: what the paper claims, with verdicts from a store. A claim that is not reproduced is a
// finding, not an error.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "edgewise/cli/command.hpp"
#include "edgewise/cli/store_path.hpp"
#include "edgewise/reports/paper/claims/claims.hpp"

namespace edgewise::cli {

namespace {

using nlohmann::ordered_json;

ordered_json claim_json(const reports::Claim& claim) {
    return {{"id", claim.id},           {"section", claim.section},
            {"claim", claim.claim},     {"paper", claim.paper},
            {"ours", claim.ours},       {"unit", claim.unit},
            {"verdict", claim.verdict}, {"reason", claim.reason},
            {"rule", claim.rule},       {"deterministic", claim.deterministic}};
}

void print_json(const reports::ReportData& data, const std::vector<reports::Claim>& claims) {
    ordered_json all = ordered_json::array();
    for (const reports::Claim& claim : claims) all.push_back(claim_json(claim));
    const ordered_json machine = ordered_json::parse(data.build.machine_json, nullptr, false);
    const ordered_json out = {{"claims", all}, {"machine", machine.is_discarded() ? nullptr : machine}};
    fmt::print("{}\n", out.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
}

/// A line of short columns, then one for each longer text.
void print_table(const std::vector<reports::Claim>& claims) {
    std::size_t id = 0, section = 0;
    for (const reports::Claim& claim : claims) {
        id = std::max(id, claim.id.size());
        section = std::max(section, claim.section.size());
    }
    fmt::print("{:<{}}  {:<{}}  {}\n", "claim", id, "section", section, "verdict");
    for (const reports::Claim& claim : claims) {
        fmt::print("{:<{}}  {:<{}}  {}\n", claim.id, id, claim.section, section, claim.verdict);
        fmt::print("    {}\n    paper: {}\n", claim.claim, claim.paper);
        if (!claim.ours.empty()) fmt::print("    here: {}\n", claim.ours);
        if (!claim.reason.empty()) fmt::print("    why: {}\n", claim.reason);
    }
    fmt::print("{}\n", reports::claims_summary(claims));
}

int run(const std::string& store, bool json) {
    const reports::ReportData data = reports::read_report(store);
    const std::vector<reports::Claim> claims = reports::judge_claims(data);
    if (json)
        print_json(data, claims);
    else
        print_table(claims);
    return exit_done;
}

}  // namespace

void add_claims(CLI::App& app, Context& context) {
    auto store = std::make_shared<std::string>(default_store);
    CLI::App* command =
        add_command(app, context, "claims", "The paper's claims, each with a verdict from a store");
    command->add_option("store", *store, "store of a sweep")->capture_default_str();
    command->callback(
        [store, &context] { context.action = [=, &context] { return run(*store, context.json); }; });
}

}  // namespace edgewise::cli
