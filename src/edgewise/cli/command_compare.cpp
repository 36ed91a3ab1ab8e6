// SPDX-License-Identifier: MIT
//
// `edgewise compare`: old figures with new ones, of two stores or two records of one kind; and machine
// records of many machines: which layout wins where.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "edgewise/cli/options.hpp"
#include "edgewise/reports/compare/comparison.hpp"
#include "edgewise/reports/records/machine_record.hpp"
#include "edgewise/studies/gate/run.hpp"

namespace edgewise::cli {

namespace {

struct CompareArguments {
    std::vector<std::string> files;
    std::optional<double> slack;
    std::string format;
};

constexpr double slack_of_stores = 0.05;

/// SQLite's files begin with these words.
bool is_store(const std::string& path) {
    if (!std::filesystem::is_regular_file(path)) return false;
    constexpr std::string_view magic = "SQLite format 3";
    std::string start(magic.size(), ' ');
    std::ifstream(path, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
    return start == magic;
}

int compare_machines(const std::vector<measure::FigureRecord>& records, bool json) {
    if (json)
        print_json(reports::comparison_json(records));
    else
        fmt::print("{}", input::shown_text(reports::comparison_text(records)));
    const auto in_several = [](const reports::ComparedQuestion& question) {
        return std::ranges::count_if(question.machines, [](const auto& place) { return place.has_value(); }) >
               1;
    };
    if (records.size() == 1 || std::ranges::any_of(reports::compare_records(records), in_several))
        return exit_done;
    warn("nothing was compared: no two of the records have a question in common");
    return exit_check_failed;
}

int compare_stores(const CompareArguments& options, bool json) {
    const reports::StoreComparison comparison =
        reports::compare(reports::read_report(options.files[0]), reports::read_report(options.files[1]),
                         options.slack.value_or(slack_of_stores));
    return print_comparison(comparison.found, options.files[0], json, options.format,
                            reports::noise_text(comparison));
}

int run_compare(const CompareArguments& options, bool json) {
    const std::vector<std::string>& files = options.files;
    if (files.size() == 2 && is_store(files[0]) && is_store(files[1])) return compare_stores(options, json);
    std::vector<measure::FigureRecord> records = {measure::read_record(files[0])};
    for (std::size_t i = 1; i < files.size(); ++i)
        records.push_back(measure::read_record(files[i], records[0].kind));
    if (options.slack && !records[0].slack)
        throw std::invalid_argument(
            fmt::format("--slack is of times, and {} has none: leave it out", files[0]));
    if (records[0].kind == reports::machine_kind) {
        if (!options.format.empty())
            throw std::invalid_argument("--format is of an old file and a new one, not of machine records");
        return compare_machines(records, json);
    }
    if (records.size() != 2)
        throw std::invalid_argument("give an old file and a new one: two stores, or two records of one kind");
    if (options.slack) records[0].slack = options.slack;
    const bool is_speed = records[0].kind == studies::speed_kind;
    return print_comparison(
        is_speed ? studies::compare_speed(records[0], records[1]) : measure::compare(records[0], records[1]),
        files[0], json, options.format);
}

}  // namespace

void add_compare(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "compare",
                    "Old figures with new ones; machine records: which layout wins where", run_compare);
    command
        ->add_option("files", options.files,
                     "an old and a new store, lock or baseline; or machine records of any number")
        ->required();
    add_format_option(*command, options.format);
    add_slack_option(*command, options.slack,
                     fmt::format(" (else the old record's; {} of stores)", slack_of_stores));
}

}  // namespace edgewise::cli
