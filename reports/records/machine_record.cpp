// SPDX-License-Identifier: MIT
#include "edgewise/reports/records/machine_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/answer/ranking.hpp"

namespace edgewise::reports {

namespace {

constexpr store::FigureName modelled_ns("caches.{machine}.modelled_memory_ns");

/// Cells that anybody can measure again: those of bodies and scenes that come with Edgewise, without further
/// axes.
bool is_common(const ReportCell& cell) {
    return cell.verified() && cell.axes.empty() && cell.shape_source == "built-in";
}

/// What tables compete in.
std::string question_of(const ReportCell& cell) {
    return fmt::format("{} {} {} {}", cell.scene, cell.scene_parameters, cell.shape, cell.algorithm);
}

void add_rows(const ReportCell& cell, double low, double ratio, double high, measure::FigureRecord& record) {
    const std::string name = question_of(cell) + " " + cell.table;
    record.rows.push_back({name, ratio_figure, ratio, low, high, true});
    if (const auto bytes = cell.figure("bytes.total_bytes_per_edge").value)
        record.rows.push_back({name, "bytes per edge", *bytes});
}

std::string text_of(const nlohmann::json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// What of `edgewise machine --json` explains a ratio.
measure::Conditions facts_in(const std::string& machine_json) {
    const nlohmann::json machine = input::json_or_null(machine_json);
    const auto part = [&](const nlohmann::json& from, const char* name) {
        return from.is_object() && from.contains(name) ? from[name] : nlohmann::json();
    };
    const nlohmann::json cpu = part(machine, "cpu"), name = part(cpu, "name");
    measure::Conditions facts = {{"machine", name.is_string() ? text_of(name) : "unknown processor"},
                                 {"times", "measured"}};
    for (const char* member :
         {"vendor", "family", "model", "stepping", "cores", "threads", "vector_extensions"})
        if (const nlohmann::json value = part(cpu, member); !value.is_null())
            facts.emplace_back(fmt::format("cpu.{}", member), text_of(value));
    for (const nlohmann::json& cache : part(machine, "caches"))
        facts.emplace_back(
            fmt::format("cache.L{} {}", text_of(part(cache, "level")), text_of(part(cache, "type"))),
            fmt::format("{} bytes, {} ways, lines of {}", text_of(part(cache, "bytes")),
                        text_of(part(cache, "ways")), text_of(part(cache, "line_bytes"))));
    return facts;
}

}  // namespace

measure::FigureRecord measured_record(const ReportData& data) {
    measure::FigureRecord record{machine_kind, {}, facts_in(data.build.machine_json), {}, {}};
    for (const ReportCell& cell : data.cells) {
        if (!is_common(cell)) continue;
        const auto timed = ranked_cell(cell, std::numeric_limits<double>::infinity());
        if (!timed || !timed->interval) continue;
        add_rows(cell, std::min(timed->low(), timed->ratio), timed->ratio,
                 std::max(timed->high(), timed->ratio), record);
    }
    if (record.rows.empty())
        throw std::runtime_error("the store has no timed cell of a built-in shape; run edgewise sweep");
    return record;
}

measure::FigureRecord modelled_record(const ReportData& data, const measure::CacheMachine& machine) {
    measure::FigureRecord record{machine_kind,
                                 {},
                                 {{"machine", machine.name},
                                  {"times", "modelled misses alone: no such machine was measured"},
                                  {"cpu.name", machine.what}},
                                 {},
                                 {}};
    for (std::size_t i = 0; i < machine.caches.levels.size(); ++i)
        record.with.emplace_back(
            "cache." + machine.caches.levels[i].name,
            fmt::format("{} bytes, {} ways", machine.caches.bytes_of(i), machine.caches.levels[i].ways));
    const store::FigureName figure = modelled_ns.of(machine.name);
    std::map<std::string, double> baselines;
    for (const ReportCell& cell : data.cells) {
        const auto ns = cell.figure(figure).value;
        if (is_common(cell) && ns && cell.table == modelled_baseline) baselines[question_of(cell)] = *ns;
    }
    for (const ReportCell& cell : data.cells) {
        const auto ns = cell.figure(figure).value;
        const auto baseline = baselines.find(question_of(cell));
        if (!is_common(cell) || !ns || baseline == baselines.end()) continue;
        if (!(*ns > 0 && baseline->second > 0)) continue;  // nothing missed: the model has nothing to say
        const double ratio = *ns / baseline->second;
        add_rows(cell, ratio, ratio, ratio, record);
    }
    if (record.rows.empty())
        throw std::runtime_error(fmt::format(
            "the store has no modelled memory time of '{0}' beside {1}; run edgewise sweep --caches all --machines {0}",
            machine.name, modelled_baseline));
    return record;
}

}  // namespace edgewise::reports
