// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

constexpr int most_speed = 7;  ///< rad/s, of figure 8's axis

std::string text_parameter(const ReportCell& cell, const char* name) {
    const auto parameters = input::json_or_null(cell.scene_parameters);
    return parameters.is_object() ? parameters.value(name, "") : std::string();
}

/// "300_64MiB_4000000ns".
std::optional<ScoredSetting> setting_of(const store::FigureRow& figure) {
    ScoredSetting setting;
    if (figure.probe != "thrash" || !figure.value) return std::nullopt;
    if (std::sscanf(figure.name.c_str(), "facts.%lf_%lfMiB_%lfns", &setting.bodies, &setting.memory_mib,
                    &setting.fault_ns) != 3)
        return std::nullopt;
    setting.facts = static_cast<unsigned>(*figure.value);
    return setting;
}

std::string step_text(double time_step) {
    return time_step < 0.1 ? "1/60 s" : fmt::format("{:g} s", time_step);
}

std::vector<const ReportCell*> rows_of_run(const ReportData& data, std::string_view run, const char* member) {
    std::vector<const ReportCell*> rows;
    for (const ReportCell& cell : data.thrash)
        if (cell.run == run && !text_parameter(cell, member).empty()) rows.push_back(&cell);
    return rows;
}

/// Rows of the region's machine, by mechanism and intensity.
std::map<std::string, std::vector<ThrashRow>> by_mechanism(const std::vector<ThrashRow>& rows) {
    std::map<std::string, std::vector<ThrashRow>> groups;
    for (const ThrashRow& row : rows)
        if (row.machine == region_machine) groups[row.mechanism].push_back(row);
    return groups;
}

std::size_t count_of(const std::vector<ThrashRow>& rows, unsigned wanted) {
    std::size_t sum = 0;
    for (const ThrashRow& row : rows) sum += row.count(wanted);
    return sum;
}

std::string range_text(const std::set<double>& values) {
    if (values.size() == 1) return fmt::format("{:g}", *values.begin());
    return fmt::format("{:g} to {:g}", *values.begin(), *values.rbegin());
}

/// Ranges of settings that hold: "100 to 600 bodies, 24 to 96 MiB, 100 to 10000 us a fault; aos_f64, ...".
std::string place_text(const std::vector<ThrashRow>& rows, unsigned wanted) {
    std::set<double> bodies, memories, costs;
    std::set<std::string> tables;
    for (const ThrashRow& row : rows) {
        for (const ScoredSetting& setting : row.settings) {
            if (!setting.has(wanted)) continue;
            bodies.insert(setting.bodies);
            memories.insert(setting.memory_mib);
            costs.insert(setting.fault_ns / 1000);
            tables.insert(row.tables());
        }
    }
    return fmt::format("{} bodies, {} MiB, {} us a fault; {}", range_text(bodies), range_text(memories),
                       range_text(costs), fmt::join(tables, " or "));
}

std::string mechanisms_sentence(const std::vector<ThrashRow>& rows, unsigned wanted, const char* facts) {
    std::vector<std::string> can, cannot;
    for (const auto& [mechanism, of_it] : by_mechanism(rows)) {
        std::size_t settings = 0;
        for (const ThrashRow& row : of_it) settings += row.settings.size();
        const std::size_t held = count_of(of_it, wanted);
        if (held > 0)
            can.push_back(fmt::format("{} in {} of {} settings ({})", in_words(mechanism), held, settings,
                                      place_text(of_it, wanted)));
        else
            cannot.push_back(fmt::format("{} in none of {}", in_words(mechanism), settings));
    }
    std::string text = fmt::format("{}: ", facts);
    text += can.empty() ? "no mechanism gives them" : fmt::format("{}", fmt::join(can, "; "));
    if (!cannot.empty()) text += fmt::format("; {}", fmt::join(cannot, "; "));
    return text + ".";
}

/// Returns the sentence on settings with memory for all tables; only caches and TLB can be the cause.
std::string caches_sentence(const std::vector<ThrashRow>& rows) {
    double most = 0;
    std::size_t settings = 0, with = 0;
    for (const ThrashRow& row : rows)
        for (const ScoredSetting& setting : row.settings) most = std::max(most, setting.memory_mib);
    for (const ThrashRow& row : rows) {
        if (row.mechanism != "queries_alone") continue;
        for (const ScoredSetting& setting : row.settings) {
            if (setting.memory_mib != most || setting.bodies > 300) continue;
            ++settings;
            with += setting.has(takes_as_long);
        }
    }
    return fmt::format(
        "With memory for all tables ({:g} MiB, up to 300 bodies) queries alone, that is caches and TLB, take "
        "figure 8's time in {} of {} settings.",
        most, with, settings);
}

std::string realised_sentence(const ReportData& data) {
    std::map<int, std::vector<RealisedRow>> cells;
    std::string reason;
    for (const RealisedRow& row : realised_rows(data)) {
        cells[row.number].push_back(row);
        if (!row.cell->verified()) reason = row.cell->reason;
    }
    if (cells.empty()) return "No cell was made real.";
    if (!reason.empty()) return fmt::format("No cell was made real: {}.", reason);
    std::vector<std::string> texts;
    for (const auto& [number, curves] : cells) {
        double large = 0, small = 0, gjk_large = 0, gjk_small = 0, worst = 0;
        for (const RealisedRow& row : curves) {
            const bool is_large = row.cell->vertices == 386, is_vclip = row.cell->algorithm == "vclip";
            double& longest = is_vclip ? (is_large ? large : small) : (is_large ? gjk_large : gjk_small);
            longest = 0;
            for (const auto& point : row.points) longest = std::max(longest, point.measured_us);
            worst = std::max(worst, row.worst_ratio());
        }
        texts.push_back(fmt::format(
            "{}: V-Clip's longest time {} us at 386 vertices and {} at 38, GJK's {} and {}; at worst {} times "
            "its prediction or one over that",
            curves.front().what, number_text(large), number_text(small), number_text(gjk_large),
            number_text(gjk_small), number_text(worst)));
    }
    return fmt::format("Made real on this machine ({}): {}.", plural(cells.size(), "cell"),
                       fmt::join(texts, ". "));
}

std::string other_machines_sentence(const std::vector<ThrashRow>& rows) {
    std::map<std::string, double> with;
    for (const ThrashRow& row : rows)
        with[row.machine] += row.cell->figure("thrash.settings_with_all").value.value_or(0);
    std::vector<std::string> texts;
    for (const auto& [machine, count] : with) texts.push_back(fmt::format("{:g} on {}", count, machine));
    return fmt::format("Settings with all four facts: {}.", fmt::join(texts, ", "));
}

}  // namespace

std::size_t ThrashRow::count(unsigned wanted) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(settings, [&](const ScoredSetting& one) { return one.has(wanted); }));
}

std::string ThrashRow::name() const {
    return intensity > 0 ? fmt::format("{} {:g}", in_words(mechanism), intensity) : in_words(mechanism);
}

std::string ThrashRow::tables() const {
    return fmt::format("{}, {}, steps of {}", cell->table, own_tables ? "own tables" : "a shared table",
                       step_text(time_step));
}

double RealisedRow::worst_ratio() const {
    double worst = 1;
    for (const Point& point : points)
        worst =
            std::max({worst, point.measured_us / point.predicted_us, point.predicted_us / point.measured_us});
    return worst;
}

std::vector<ThrashRow> thrash_rows(const ReportData& data) {
    std::vector<ThrashRow> rows;
    for (const ReportCell* cell : rows_of_run(data, "thrash", "mechanism")) {
        ThrashRow row;
        row.cell = cell;
        row.mechanism = text_parameter(*cell, "mechanism");
        row.machine = text_parameter(*cell, "machine");
        row.intensity = parameter_of(*cell, "intensity").value_or(0);
        row.time_step = parameter_of(*cell, "time_step").value_or(0);
        row.own_tables = parameter_of(*cell, "own_tables").value_or(0) != 0;
        for (const store::FigureRow& figure : cell->figures)
            if (const auto setting = setting_of(figure)) row.settings.push_back(*setting);
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<RealisedRow> realised_rows(const ReportData& data) {
    std::vector<RealisedRow> rows;
    for (const ReportCell* cell : rows_of_run(data, "thrash_realised", "mechanism")) {
        RealisedRow row;
        row.cell = cell;
        const auto number = [&](const char* name) { return parameter_of(*cell, name).value_or(0); };
        row.number = static_cast<int>(number("number"));
        row.what = fmt::format("{:g} bodies, {:g} MiB, {:g} us a fault; {}, {}, steps of {}",
                               number("bodies"), number("memory_mib"), number("fault_us"), cell->table,
                               number("own_tables") != 0 ? "own tables" : "a shared table",
                               step_text(number("time_step")));
        for (int speed = 1; speed <= most_speed; ++speed) {
            const std::string at = std::to_string(speed);
            const auto figure = [&](const store::FigureName& name) {
                return cell->figure(name.of(at)).value;
            };
            const auto measured = figure("thrash.measured_us.{speed}"),
                       predicted = figure("thrash.predicted_us.{speed}");
            if (!measured || !predicted) continue;
            row.points.push_back(
                {static_cast<double>(speed), *measured, *predicted, figure("thrash.measured_faults.{speed}"),
                 figure("thrash.predicted_faults.{speed}"), figure("thrash.model_us.{speed}")});
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::string settled_paragraph(const ReportData& data) {
    const std::vector<ThrashRow> rows = thrash_rows(data);
    if (rows.empty()) return {};
    return prose("thrash_settled.md",
                 fmt::arg("all", mechanisms_sentence(rows, all_facts, "All four facts of figure 8")),
                 fmt::arg("three", mechanisms_sentence(rows, all_but_erratic,
                                                       "Three of them, without the ups and downs")),
                 fmt::arg("machines", other_machines_sentence(rows)),
                 fmt::arg("caches", caches_sentence(rows)), fmt::arg("realised", realised_sentence(data)));
}

TextGrid mechanism_grid(const ReportData& data) {
    TextGrid grid{
        "Possible causes of figure 8: settings (bodies x memory x cost of a fault) where its facts "
        "hold in the model",
        columns_of("mechanism|table type, time step|processor|#settings|#rises|#takes as long|"
                   "#spares GJK|#erratic|#all|#most at once|#rise there|#us there|#GJK there")};
    for (const ThrashRow& row : thrash_rows(data)) {
        const auto cell = [&](const store::FigureName& name) { return figure_cell(row.cell->figure(name)); };
        const auto with = [&](const char* fact) {
            return cell(store::FigureName("thrash.settings_with.{fact}").of(fact));
        };
        grid.add(row.name(), row.tables(), row.machine, cell("thrash.settings"), with("rises"),
                 with("takes_as_long"), with("spares_gjk"), with("erratic"), cell("thrash.settings_with_all"),
                 cell("thrash.best_facts"), cell("thrash.best.rise"), cell("thrash.best.top_us"),
                 cell("thrash.best.gjk_rise"));
    }
    return grid;
}

TextGrid realised_grid(const ReportData& data) {
    TextGrid grid{
        "Figure 8 made real: us per query by speed, measured and predicted here, and modelled on a processor of "
        "the time",
        columns_of(
            "cell|shape|algorithm|#rad/s|#measured|#predicted|#over it|#faults|#predicted faults|#modelled")};
    const auto optional_text = [](const std::optional<double>& value) {
        return value ? number_text(*value) : std::string("–");
    };
    for (const RealisedRow& row : realised_rows(data))
        for (const RealisedRow::Point& point : row.points)
            grid.add(row.what, row.cell->shape, row.cell->algorithm, number_text(point.speed),
                     number_text(point.measured_us), number_text(point.predicted_us),
                     number_text(point.measured_us / point.predicted_us),
                     optional_text(point.measured_faults), optional_text(point.predicted_faults),
                     optional_text(point.model_us));
    return grid;
}

}  // namespace edgewise::reports
