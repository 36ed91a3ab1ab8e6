// SPDX-License-Identifier: MIT
//
// `edgewise machine`: what this machine is, which counters it has, and why not.
#include <fmt/format.h>

#include <algorithm>

#include "edgewise/cli/command.hpp"
#include "edgewise/cli/terminal/text_table.hpp"
#include "edgewise/measure/machine/machine_json.hpp"

namespace edgewise::cli {

namespace {

using Json = nlohmann::json;

std::string text_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.is_null() ? "?" : value.dump();
}

/// A member per line; its lists with commas, and what a fact's reason says where it is not known.
void print_facts(const Json& facts) {
    TextTable table({"fact", "value"});
    for (const auto& [key, value] : facts.items()) {
        std::string text;
        if (!value.is_array()) text = text_of(value);
        if (value.is_array())
            for (const Json& item : value) text += (text.empty() ? "" : ", ") + text_of(item);
        table.add({key, text});
    }
    fmt::print("{}\n", table.text());
}

void print_caches(const Json& caches) {
    TextTable table({"cache", "type", "#bytes", "#ways", "#line", "#sets", "shared by"});
    for (const Json& cache : caches)
        table.add({"L" + text_of(cache["level"]), text_of(cache["type"]), text_of(cache["bytes"]),
                   text_of(cache["ways"]), text_of(cache["line_bytes"]), text_of(cache["sets"]),
                   text_of(cache["shared_cpus"])});
    fmt::print("{}\n", table.text());
}

/// Each reason once, with the number that stands beside the events that it is of.
void print_counters(const Json& counters) {
    TextTable table({"event", "level", "by", "#counted", "meaning"});
    std::vector<std::string> reasons;
    for (const Json& counter : counters) {
        std::string value = text_of(counter["value"]);
        if (counter["status"] != "counted") {
            const std::string error =
                counter["errno"].is_null() ? "" : fmt::format(" (errno {})", counter["errno"].dump());
            const std::string reason =
                fmt::format("{}{}; {}", text_of(counter["reason"]), error, text_of(counter["remedy"]));
            auto found = std::ranges::find(reasons, reason);
            if (found == reasons.end()) found = reasons.insert(reasons.end(), reason);
            value = fmt::format("no [{}]", found - reasons.begin() + 1);
        } else if (counter["unit"] == "ns") {
            value += " ns";
        }
        table.add({text_of(counter["event"]), text_of(counter["level"]), text_of(counter["by"]), value,
                   text_of(counter["meaning"])});
    }
    fmt::print("{}", table.text());
    for (std::size_t i = 0; i < reasons.size(); ++i)
        fmt::print("[{}] {}\n", i + 1, folded(reasons[i], widest_line - 4, 4));
}

struct MachineArguments {};

int run_machine(const MachineArguments& /*none*/, bool as_json) {
    Json machine = measure::machine_json();
    if (as_json) {
        print_json(machine);
        return exit_done;
    }
    Json facts = machine;
    for (const char* apart : {"cpu", "caches", "counters", "unreadable"}) facts.erase(apart);
    print_facts(machine["cpu"]);
    print_caches(machine["caches"]);
    print_facts(facts);
    print_counters(machine["counters"]);
    for (const auto& [what, reason] : machine["unreadable"].items())
        fmt::print("{}: not known: {}\n", what, text_of(reason));
    fmt::print("encodings of the events: --json\n");
    return exit_done;
}

}  // namespace

void add_machine(CLI::App& app, Context& context) {
    add_command(app, context, "machine",
                "What this machine is, and which counters it has, or why one is missing", run_machine);
}

}  // namespace edgewise::cli
