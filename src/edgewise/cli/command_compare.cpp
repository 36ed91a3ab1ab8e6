// SPDX-License-Identifier: MIT
//
// `edgewise compare`: machine records of many machines beside each other: which layout wins where.
#include <fmt/format.h>

#include <algorithm>

#include "edgewise/cli/command.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/reports/records/compare_records.hpp"

namespace edgewise::cli {

namespace {

struct CompareArguments {
    std::vector<std::string> records;
};

reports::MachineRecord record_in(const std::string& path) {
    return reports::parse_record(input::read_file_text(path).or_throw(), path);
}

int run_compare(const CompareArguments& options, bool json) {
    std::vector<reports::MachineRecord> records;
    for (const std::string& path : options.records) records.push_back(record_in(path));
    if (json)
        print_json(reports::comparison_json(records));
    else
        fmt::print("{}", reports::comparison_text(records));
    const auto in_several = [](const reports::ComparedQuestion& question) {
        return std::ranges::count_if(question.machines, [](const auto& place) { return place.has_value(); }) >
               1;
    };
    if (records.size() == 1 || std::ranges::any_of(reports::compare_records(records), in_several))
        return exit_done;
    warn("nothing was compared: no two of the records have a question in common");
    return exit_check_failed;
}

}  // namespace

void add_compare(CLI::App& app, Context& context) {
    auto [command, options] = add_command(
        app, context, "compare", "Machine records beside each other: which layout wins where", run_compare);
    command->add_option("records", options.records, "files of edgewise export --machine-record")->required();
}

}  // namespace edgewise::cli
