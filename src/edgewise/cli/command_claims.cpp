// SPDX-License-Identifier: MIT
//
// `edgewise report claims`: the paper's claims, each with a verdict from a store, or what two stores say
// differently. Without the folder that adds the paper there is no such command.
#include "edgewise/cli/options.hpp"
#include "edgewise/measure/record/comparison.hpp"
#include "edgewise/reports/additions.hpp"

namespace edgewise::cli {

namespace {

struct ClaimsArguments {
    std::string store = default_store;
    std::string other;  ///< of --diff; empty: one store alone
};

int run_claims(const ClaimsArguments& options, bool json) {
    const reports::Addition& paper = reports::additions().front();
    const reports::ReportData data = reports::read_report(options.store);
    if (options.other.empty()) {
        fmt::print("{}", paper.claims_text(data, json));
        return exit_done;
    }
    const measure::RecordComparison found =
        measure::compare(paper.claims_record(data), paper.claims_record(reports::read_report(options.other)));
    fmt::print("{}", json ? to_json(found) : input::shown_text(to_text(found, options.store)));
    return found.exit_code();
}

}  // namespace

void add_claims(CLI::App& report, Context& context) {
    if (reports::additions().empty()) return;
    auto [command, options] = add_command(report, context, "claims",
                                          "The paper's claims, each with a verdict from a store", run_claims);
    add_read_store_option(*command, options.store);
    command->add_option("--diff", options.other,
                        "what another store says differently; exit code 1 where something does");
}

}  // namespace edgewise::cli
