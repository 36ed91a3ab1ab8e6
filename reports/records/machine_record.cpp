// SPDX-License-Identifier: MIT
#include "edgewise/reports/records/machine_record.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/answer/ranking.hpp"

namespace edgewise::reports {

namespace {

using RecordJson = nlohmann::ordered_json;

constexpr int record_version = 1;
constexpr store::FigureName modelled_ns("caches.{machine}.modelled_memory_ns");

/// Cells that anybody can measure again: those of bodies and scenes that come with Edgewise, without further
/// axes.
bool is_common(const ReportCell& cell) {
    return cell.verified() && cell.axes.empty() && cell.shape_source == "built-in";
}

RecordRow row_of(const ReportCell& cell) {
    RecordRow row{cell.scene, cell.scene_parameters, cell.shape, cell.algorithm, cell.table, 0, 0, 0, {}};
    row.bytes_per_edge = cell.figure("bytes.total_bytes_per_edge").value;
    return row;
}

/// The named members of an object, null where it lacks one.
nlohmann::json members(const nlohmann::json& object, std::initializer_list<const char*> names) {
    nlohmann::json result = nlohmann::json::object();
    for (const char* name : names)
        result[name] = object.is_object() && object.contains(name) ? object[name] : nlohmann::json();
    return result;
}

/// Of `edgewise machine --json`, what explains a ratio.
void take_facts(const std::string& machine_json, MachineRecord& record) {
    const nlohmann::json machine = input::json_or_null(machine_json);
    const auto part = [&](const char* name) {
        return machine.is_object() && machine.contains(name) ? machine[name] : nlohmann::json();
    };
    record.cpu = members(part("cpu"), {"vendor", "name", "family", "model", "stepping", "cores", "threads",
                                       "vector_extensions"});
    record.caches = nlohmann::json::array();
    for (const nlohmann::json& cache : part("caches"))
        record.caches.push_back(members(cache, {"level", "type", "bytes", "ways", "line_bytes"}));
    record.machine =
        record.cpu["name"].is_string() ? record.cpu["name"].get<std::string>() : "unknown processor";
}

template <class Value>
Value member(const nlohmann::json& object, const char* key, const std::string& where) {
    try {
        return object.at(key).get<Value>();
    } catch (const nlohmann::json::exception&) {
        throw std::runtime_error(fmt::format(
            "{}: '{}' is missing or of another type; edgewise export --machine-record writes such files",
            where, key));
    }
}

void refuse_others(const nlohmann::json& object, const char* what, const std::vector<std::string>& known,
                   const std::string& where) {
    const std::string unknown = input::unknown_member(object, what, known);
    if (!unknown.empty()) throw std::runtime_error(fmt::format("{}: {}", where, unknown));
}

RecordRow row_from(const nlohmann::json& object, const std::string& where) {
    RecordRow row;
    row.scene = member<std::string>(object, "scene", where);
    refuse_others(
        object, "a row",
        {"scene", "parameters", "shape", "algorithm", "table", "ratio", "low", "high", "bytes_per_edge"},
        where);
    row.parameters = member<nlohmann::json>(object, "parameters", where).dump();
    row.shape = member<std::string>(object, "shape", where);
    row.algorithm = member<std::string>(object, "algorithm", where);
    row.table = member<std::string>(object, "table", where);
    row.ratio = member<double>(object, "ratio", where);
    row.low = member<double>(object, "low", where);
    row.high = member<double>(object, "high", where);
    if (!(row.low > 0 && row.low <= row.ratio && row.ratio <= row.high && std::isfinite(row.high)))
        throw std::runtime_error(fmt::format("{}: {} of {}: 0 < low <= ratio <= high must hold", where,
                                             row.table, row.question()));
    if (object.contains("bytes_per_edge") && object["bytes_per_edge"].is_number())
        row.bytes_per_edge = object["bytes_per_edge"].get<double>();
    return row;
}

}  // namespace

std::string RecordRow::question() const {
    return fmt::format("{} {} {} {}", scene, parameters, shape, algorithm);
}

MachineRecord measured_record(const ReportData& data) {
    MachineRecord record;
    take_facts(data.build.machine_json, record);
    for (const ReportCell& cell : data.cells) {
        if (!is_common(cell)) continue;
        const auto timed = ranked_cell(cell, std::numeric_limits<double>::infinity());
        if (!timed || !timed->interval) continue;
        RecordRow row = row_of(cell);
        row.ratio = timed->ratio;
        row.low = std::min(timed->low(), timed->ratio);
        row.high = std::max(timed->high(), timed->ratio);
        record.rows.push_back(std::move(row));
    }
    if (record.rows.empty())
        throw std::runtime_error("the store has no timed cell of a built-in shape; run edgewise sweep");
    return record;
}

MachineRecord modelled_record(const ReportData& data, const std::string& machine) {
    MachineRecord record;
    record.machine = machine;
    record.is_model = true;
    const store::FigureName figure = modelled_ns.of(machine);
    std::map<std::string, double> baselines;
    for (const ReportCell& cell : data.cells) {
        const auto ns = cell.figure(figure).value;
        if (is_common(cell) && ns && cell.table == modelled_baseline)
            baselines[row_of(cell).question()] = *ns;
    }
    for (const ReportCell& cell : data.cells) {
        RecordRow row = row_of(cell);
        const auto ns = cell.figure(figure).value;
        const auto baseline = baselines.find(row.question());
        if (!is_common(cell) || !ns || baseline == baselines.end()) continue;
        if (!(*ns > 0 && baseline->second > 0)) continue;  // nothing missed: the model has nothing to say
        row.ratio = row.low = row.high = *ns / baseline->second;
        record.rows.push_back(std::move(row));
    }
    if (record.rows.empty())
        throw std::runtime_error(fmt::format(
            "the store has no modelled memory time of '{}' beside {}; run edgewise sweep --caches all --machines {}",
            machine, modelled_baseline, machine));
    return record;
}

nlohmann::ordered_json to_json(const MachineRecord& record) {
    RecordJson rows = RecordJson::array();
    for (const RecordRow& row : record.rows) {
        RecordJson one = {{"scene", row.scene}, {"parameters", input::json_or_null(row.parameters)},
                          {"shape", row.shape}, {"algorithm", row.algorithm},
                          {"table", row.table}, {"ratio", row.ratio},
                          {"low", row.low},     {"high", row.high}};
        one["bytes_per_edge"] = row.bytes_per_edge ? RecordJson(*row.bytes_per_edge) : RecordJson();
        rows.push_back(std::move(one));
    }
    return {{"edgewise_machine_record", record_version},
            {"machine", record.machine},
            {"times", record.is_model ? "modelled misses alone: no such machine was measured" : "measured"},
            {"cpu", record.cpu},
            {"caches", record.caches},
            {"rows", rows}};
}

MachineRecord parse_record(const std::string& text, const std::string& where) {
    const auto parsed = input::parse_json(text);
    if (!parsed)
        throw std::runtime_error(fmt::format(
            "{}: {}; wants a record (edgewise_machine_record) of edgewise export --machine-record", where,
            parsed.error));
    const nlohmann::json& object = *parsed;
    const int version = member<int>(object, "edgewise_machine_record", where);
    if (version != record_version)
        throw std::runtime_error(fmt::format("{}: a record of version {}, not {}; take a newer edgewise",
                                             where, version, record_version));
    refuse_others(object, "a record",
                  {"edgewise_machine_record", "machine", "times", "cpu", "caches", "rows"}, where);
    MachineRecord record;
    record.machine = member<std::string>(object, "machine", where);
    record.is_model = member<std::string>(object, "times", where) != "measured";
    record.cpu = member<nlohmann::json>(object, "cpu", where);
    record.caches = member<nlohmann::json>(object, "caches", where);
    for (const nlohmann::json& row : member<nlohmann::json>(object, "rows", where))
        record.rows.push_back(row_from(row, where));
    if (record.rows.empty()) throw std::runtime_error(where + ": a record without rows");
    return record;
}

}  // namespace edgewise::reports
