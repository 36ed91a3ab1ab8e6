// SPDX-License-Identifier: MIT
//
// JSON by nlohmann-json; this file checks what stands in it. Inside, the first fault is thrown and caught
// once.
#include "edgewise/studies/gate/file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "edgewise/input/file_text.hpp"
#include "edgewise/input/json_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/input/output_file.hpp"

namespace edgewise::studies {

namespace {

using nlohmann::json;

constexpr int gate_version = 1;
constexpr const char* over_names[] = {"reference", "kernel"};
constexpr const char* remedy = "write the baseline anew with --write";

struct GateFault {
    std::string what;
};

template <class Value>
Value gate_member(const json& object, const std::string& place, const char* key, const char* wanted) {
    try {
        return object.at(key).get<Value>();
    } catch (const json::exception&) {
        throw GateFault{fmt::format("{}{} wants {}", place, key, wanted)};
    }
}

std::string gate_text(const json& object, const std::string& place, const char* key) {
    return gate_member<std::string>(object, place, key, "a text");
}

double gate_number(const json& object, const std::string& place, const char* key, double least) {
    const auto value = gate_member<double>(object, place, key, "a number");
    if (!(std::isfinite(value) && value >= least))
        throw GateFault{fmt::format("{}{} = {} wants a number from {} on", place, key, value, least)};
    return value;
}

void refuse_others(const json& object, const std::string& place, const char* what,
                   const std::vector<std::string>& known) {
    const std::string unknown = input::unknown_member(object, what, known);
    if (!unknown.empty()) throw GateFault{place + unknown};
}

template <class Whole>
Whole gate_whole(const json& object, const char* key) {
    constexpr double most = 1e9;
    const double value = gate_number(object, "", key, 1);
    if (value > most || value != std::floor(value))
        throw GateFault{fmt::format("{} = {} wants a whole number up to {}", key, value, most)};
    return static_cast<Whole>(value);
}

GateOver over_of(const json& object, const std::string& place) {
    const std::string over = gate_text(object, place, "over");
    if (over == over_names[0]) return GateOver::reference;
    if (over == over_names[1]) return GateOver::kernel;
    throw GateFault{fmt::format("{}over: {}", place, unknown_name("ratio", over, {"reference", "kernel"}))};
}

GateEntry entry_of(const json& object, const std::string& place) {
    constexpr double tiniest = 1e-30;
    if (!object.is_object())
        throw GateFault{place.substr(0, place.size() - 1) +
                        " wants to be an object with algorithm, table ..."};
    refuse_others(object, place, "an entry of a baseline",
                  {"algorithm", "table", "scene", "shape", "axes", "over", "ratio", "low", "high"});
    GateEntry entry;
    entry.algorithm = gate_text(object, place, "algorithm");
    entry.table = gate_text(object, place, "table");
    entry.scene = gate_text(object, place, "scene");
    entry.shape = gate_text(object, place, "shape");
    entry.axes = gate_text(object, place, "axes");
    entry.over = over_of(object, place);
    entry.ratio = {gate_number(object, place, "ratio", tiniest), gate_number(object, place, "low", 0),
                   gate_number(object, place, "high", 0)};
    return entry;
}

GateRecord record_of(const json& object) {
    if (!object.is_object()) throw GateFault{"wants one object, as --write makes it"};
    refuse_others(object, "", "a baseline",
                  {"gate", "machine", "build", "rounds", "queries", "slack", "entries"});
    if (gate_number(object, "", "gate", 0) != gate_version)
        throw GateFault{fmt::format("gate wants {}, the only version there is", gate_version)};
    GateRecord record;
    record.machine = gate_text(object, "", "machine");
    const json build = gate_member<json::object_t>(object, "", "build", "an object");
    refuse_others(build, "build.", "a build", {"git_revision", "compiler", "flags", "build_type"});
    record.git_revision = gate_text(build, "build.", "git_revision");
    record.compiler = gate_text(build, "build.", "compiler");
    record.flags = gate_text(build, "build.", "flags");
    record.build_type = gate_text(build, "build.", "build_type");
    record.rounds = gate_whole<int>(object, "rounds");
    record.queries = gate_whole<std::size_t>(object, "queries");
    record.slack = gate_number(object, "", "slack", 0);
    std::set<std::string> names;
    for (const json& each : gate_member<json::array_t>(object, "", "entries", "a list")) {
        const std::string place = fmt::format("entries[{}].", record.entries.size());
        record.entries.push_back(entry_of(each, place));
        if (!names.insert(record.entries.back().name()).second)
            throw GateFault{fmt::format("{} names '{}' again", place, record.entries.back().name())};
    }
    return record;
}

}  // namespace

json gate_json(const GateRecord& record) {
    json entries = json::array();
    for (const GateEntry& entry : record.entries) {
        entries.push_back({{"algorithm", entry.algorithm},
                           {"table", entry.table},
                           {"scene", entry.scene},
                           {"shape", entry.shape},
                           {"axes", entry.axes},
                           {"over", over_names[static_cast<std::size_t>(entry.over)]},
                           {"ratio", entry.ratio.value},
                           {"low", entry.ratio.low},
                           {"high", entry.ratio.high}});
    }
    return {{"gate", gate_version},
            {"machine", record.machine},
            {"build",
             {{"git_revision", record.git_revision},
              {"compiler", record.compiler},
              {"flags", record.flags},
              {"build_type", record.build_type}}},
            {"rounds", record.rounds},
            {"queries", record.queries},
            {"slack", record.slack},
            {"entries", entries}};
}

Result<GateRecord> parse_gate(const std::string& name, const std::string& text) {
    const auto parsed = input::parse_json(text);
    if (!parsed) return Result<GateRecord>::failure(fmt::format("{}: {}; {}", name, parsed.error, remedy));
    try {
        return Result<GateRecord>::success(record_of(*parsed));
    } catch (const GateFault& fault) {
        return Result<GateRecord>::failure(fmt::format("{}: {}; {}", name, fault.what, remedy));
    }
}

Result<GateRecord> read_gate(const std::string& path) {
    const auto text = input::read_file_text(path);
    if (!text) return Result<GateRecord>::failure(fmt::format("{}; {}", text.error, remedy));
    return parse_gate(path, *text);
}

void write_gate(const std::string& path, const GateRecord& record) {
    input::write_output(path, gate_json(record).dump(1) + "\n");
}

}  // namespace edgewise::studies
