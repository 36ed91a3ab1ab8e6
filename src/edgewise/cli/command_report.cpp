// SPDX-License-Identifier: MIT
//
// `edgewise report`: writes the pages of a store again. And `report claims`: the paper's claims, each with a
// verdict from a store, or what two stores say differently. Without the folder that adds the paper there is
// no such command.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/reports/additions.hpp"
#include "edgewise/reports/compare/comparison.hpp"
#include "edgewise/reports/page/report.hpp"

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
    return print_comparison(
        measure::compare(paper.claims_record(data), paper.claims_record(reports::read_report(options.other))),
        options.store, json);
}

void add_claims(CLI::App& report, Context& context) {
    if (reports::additions().empty()) return;
    auto [command, options] = add_command(report, context, "claims",
                                          "The paper's claims, each with a verdict from a store", run_claims);
    add_read_store_option(*command, options.store);
    command->add_option("--diff", options.other,
                        "what another store says differently; exit code 1 where something does");
}

struct ReportArguments {
    std::string store = default_store;
    std::string out, compare;
    bool explain = false, gate = false;
    double slack = 0.05;
};

/// How far a report is, for those that take long.
class ReportProgress {
  public:
    explicit ReportProgress(std::size_t stores)
        : progress_("report", stores * percents + reports::report_parts, 0, "parts", quiet_seconds) {}

    [[nodiscard]] reports::ReportData read(const std::string& store) {
        std::size_t shown = 0;
        return reports::read_report(store, {}, [&](std::size_t done, std::size_t all) {
            const std::size_t now = percents * done / all;
            progress_.advance(now - shown, "reading " + store);
            shown = now;
        });
    }
    [[nodiscard]] reports::OnReportPart on_part() {
        return [this](const std::string& part) { progress_.advance(1, part); };
    }

  private:
    static constexpr std::size_t percents = 100;
    static constexpr double quiet_seconds = 10;
    Progress progress_;
};

/// The folder that the report is written to, which is there then.
std::string out_of(const ReportArguments& options) {
    if (!options.out.empty() && std::filesystem::exists(options.store)) make_folder(options.out, "--out");
    return options.out.empty() ? folder_of(options.store) : options.out;
}

/// What changed from the other store to this one, here and in the pages.
int run_compare(const ReportArguments& options, bool json) {
    auto progress = std::make_unique<ReportProgress>(2);
    const reports::ReportData data = progress->read(options.store);
    reports::StoreComparison comparison =
        reports::compare(progress->read(options.compare), data, options.slack);
    measure::RecordComparison& found = comparison.found;
    if (found.compared() == 0)
        throw std::invalid_argument(fmt::format("{} and {} have no cell in common: nothing to compare",
                                                options.store, options.compare));
    const reports::ReportSummary summary = reports::write_report(
        data, out_of(options), bench::charts_folder(),
        reports::ReportBeside{&comparison, options.slack,
                              std::filesystem::path(options.compare).filename().string()},
        progress->on_part());
    progress.reset();
    if (!summary.note.empty()) warn(summary.note);
    if (!options.explain) {
        found.conditions.clear();
        for (measure::ComparedRow& row : found.rows) row.note.clear();
    }
    if (json) {
        nlohmann::json line = nlohmann::json::parse(to_json(found));
        line["report"] = summary.page;
        print_json(line);
    } else {
        print_comparison(found, options.compare, false, "", reports::noise_text(comparison));
        fmt::print("report: {}\n", summary.page);
    }
    return options.gate ? found.exit_code() : exit_done;
}

int run_report(const ReportArguments& options, bool json) {
    if (!options.compare.empty()) return run_compare(options, json);
    auto progress = std::make_unique<ReportProgress>(1);
    const reports::ReportSummary summary = reports::write_report(
        progress->read(options.store), out_of(options), bench::charts_folder(), {}, progress->on_part());
    progress.reset();
    if (!summary.note.empty()) warn(summary.note);
    if (json) {
        const nlohmann::json line = {{"cells", summary.cells},   {"verified", summary.verified},
                                     {"failed", summary.failed}, {"unavailable", summary.unavailable},
                                     {"store", options.store},   {"report", summary.page}};
        print_json(line);
    } else {
        fmt::print("report: {}\n\n{}\n", summary.page, input::shown_text(summary.answer));
    }
    return exit_done;
}

}  // namespace

void add_report(CLI::App& app, Context& context) {
    auto [command, options] = add_command(app, context, "report", "Writes the report of a store", run_report);
    add_read_store_option(*command, options.store);
    command->add_option("--out", options.out, "folder to write: the report; the store's folder if not given");
    CLI::Option* const compare = command->add_option(
        "--compare", options.compare,
        "what changed since this other store, regressions first: printed, and a chapter of the report");
    command
        ->add_flag("--explain", options.explain, "what each change is made of, and which causes are excluded")
        ->needs(compare);
    command->add_flag("--gate", options.gate, "exit code 1 where something became worse")->needs(compare);
    add_slack_option(*command, options.slack, "")->needs(compare);
    add_claims(*command, context);
}

}  // namespace edgewise::cli
