// SPDX-License-Identifier: MIT
//
// `edgewise caches`: a trace of addresses, from a file or of one cell, through the caches of several
// machines: misses by level, distinct lines, and how large a cache must be. A cell's trace can be written for
// others.
#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "edgewise/cli/options.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/traces/trace_file.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::cli {

namespace {

struct CachesArguments {
    studies::CellChoice cell;
    std::string trace, write;
    bool fetches = false;
    std::vector<std::string> machines = {"pentium3_coppermine", "zen5"};
};

/// A trace: what it is of, and its counts.
struct Traced {
    std::string what;
    measure::TraceCounts counts;
    bool fetches = false;
};

/// It is read twice, so no pipe will do.
std::ifstream opened(const std::string& file) {
    if (const std::string wrong = input::what_is_wrong_with(file); !wrong.empty())
        throw std::runtime_error(file + ": " + wrong);
    return std::ifstream(file);
}

Traced trace_file(const CachesArguments& options, measure::TraceCaches& caches) {
    std::ifstream first = opened(options.trace);
    const measure::TraceForm form = measure::form_of(first, options.trace);
    std::ifstream stream = opened(options.trace);
    const measure::TraceCounts counts =
        measure::read_trace(stream, options.trace, {form, options.fetches},
                            [&](const measure::FileAccess& access) { caches.access(access); });
    constexpr std::uint64_t surely_hexadecimal =
        100;  // this number of addresses without a letter are decimal
    if (!counts.has_letters && counts.reads + counts.writes + counts.fetches >= surely_hexadecimal)
        warn(options.trace +
             ": no address has a digit above 9: addresses are read as hexadecimal, and these look "
             "decimal");
    const char* const name = form == measure::TraceForm::din ? "din" : "lackey";
    return {fmt::format("{} ({})", options.trace, name), counts, options.fetches};
}

Traced trace_cell(const CachesArguments& options, measure::TraceCaches& caches) {
    const studies::SingleCell cell(options.cell);
    if (options.write.empty()) {
        static_cast<void>(cell.runner().trace(bench::TraceExtent::everything(), caches));
    } else {
        input::OutputFile file(options.write);
        measure::DinWriter writer(file.stream());
        measure::TraceFanOut both({&caches, &writer});
        static_cast<void>(cell.runner().trace(bench::TraceExtent::everything(), both));
        file.finish();
    }
    return {fmt::format("{} {}, {} {}", options.cell.table, options.cell.algorithm, options.cell.scene,
                        bodies_of(options.cell)),
            {caches.reads(), caches.writes()},
            false};
}

nlohmann::json part_of(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? nlohmann::json()
                      : nlohmann::json(static_cast<double>(part) / static_cast<double>(whole));
}

nlohmann::json json_of(const Traced& traced, const measure::TraceCaches& caches,
                       const std::vector<measure::MachineChoice>& choices) {
    nlohmann::json machines = nlohmann::json::array(), sizes = nlohmann::json::array();
    std::size_t next = 0;
    for (const measure::MachineChoice& choice : choices) {
        nlohmann::json machine = {{"machine", choice.name}, {"reason", or_null(choice.machine.reason)}};
        machine["levels"] = nlohmann::json::array();
        if (choice.machine.value) {
            for (const auto& [level, counts] : caches.levels(next++))
                machine["levels"].push_back({{"level", level},
                                             {"accesses", counts.accesses},
                                             {"misses", counts.misses},
                                             {"miss_part", part_of(counts.misses, counts.accesses)},
                                             {"write_backs", counts.write_backs}});
        }
        machines.push_back(std::move(machine));
    }
    for (int power = 10; power <= 26; power += 2)
        sizes.push_back({{"bytes", 1 << power}, {"misses", caches.misses(std::uint64_t{1} << power)}});
    return {{"trace", traced.what},
            {"reads", traced.counts.reads},
            {"writes", traced.counts.writes},
            {"fetches", traced.counts.fetches},
            {"fetches_modelled", traced.fetches},
            {"distinct_lines", caches.distinct_lines()},
            {"knee_bytes", caches.knee_bytes()},
            {"machines", std::move(machines)},
            {"fully_associative", std::move(sizes)}};
}

/// A row for each level of each machine, and for each machine that was not modelled.
nlohmann::json level_rows(const nlohmann::json& machines) {
    nlohmann::json rows = nlohmann::json::array();
    for (const nlohmann::json& machine : machines) {
        if (machine["levels"].empty()) rows.push_back(machine);
        for (nlohmann::json level : machine["levels"]) {
            level["machine"] = machine["machine"];
            rows.push_back(std::move(level));
        }
    }
    return rows;
}

void print(const Traced& traced, const measure::TraceCaches& caches, const nlohmann::json& machines) {
    fmt::print("{}: {} reads, {} writes", traced.what, traced.counts.reads, traced.counts.writes);
    if (traced.counts.fetches > 0)
        fmt::print(", {} instruction fetches {}", traced.counts.fetches,
                   traced.fetches ? "as reads" : "left out");
    fmt::print("\n{} distinct lines of 64 bytes; knee {} bytes\n", caches.distinct_lines(),
               caches.knee_bytes());
    fmt::print("{}", reports::rows_text(level_rows(machines),
                                        "machine|level|#accesses|#misses|#of them, % = miss_part 0.01 2|"
                                        "#write-backs = write_backs"));
    fmt::print(
        "caches are empty at first; the knee is the smallest fully associative cache that brings in again\n"
        "at most a tenth as many lines as there are distinct ones\n");
}

int run_caches(const CachesArguments& options, bool json) {
    const std::vector<measure::MachineChoice> choices = measure::choose_machines(options.machines);
    std::vector<measure::CacheMachine> machines;
    for (const measure::MachineChoice& choice : choices)
        if (choice.machine.value) machines.push_back(*choice.machine.value);
    measure::TraceCaches caches(machines);
    const Traced traced = options.trace.empty() ? trace_cell(options, caches) : trace_file(options, caches);
    const nlohmann::json result = json_of(traced, caches, choices);
    if (json)
        print_json(result);
    else
        print(traced, caches, result["machines"]);
    return exit_done;
}

}  // namespace

void add_caches(CLI::App& app, Context& context) {
    auto [command, options] = add_command(
        app, context, "caches", "A trace of addresses through the caches of several machines", run_caches);
    CLI::Option* const trace =
        command->add_option("--trace", options.trace,
                            "file of Dinero (.din) or of Valgrind's lackey --trace-mem=yes; else one cell");
    add_cell_options(*command, options.cell);
    add_output_file(*command, "--out,--write", options.write,
                    "file to write: the cell's trace as extended din");
    for (CLI::Option* option : command->get_options())
        if (option != trace && option != command->get_help_ptr() && option->get_name() != "--json")
            trace->excludes(option);
    command->add_flag("--fetches", options.fetches, "instruction fetches of the file are reads like others")
        ->needs(trace);
    add_machines_option(*command, options.machines);
}

}  // namespace edgewise::cli
