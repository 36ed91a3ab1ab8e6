// SPDX-License-Identifier: MIT
#include "edgewise/reports/reader.hpp"

#include <fmt/core.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "edgewise/input/count.hpp"
#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

std::optional<std::string> ReportCell::axis(std::string_view name) const {
    const std::string joined = "+" + axes, start = "+" + std::string(name) + "=";
    const std::size_t at = joined.find(start);
    if (at == joined.npos) return std::nullopt;
    const std::size_t from = at + start.size();
    return joined.substr(from, joined.find('+', from) - from);
}

namespace {

std::vector<ReportCell> reader_in_order(std::vector<store::StoredCell> stored, const ReportData& data) {
    std::map<std::string, double> others;
    for (const auto& [key, value] : data.meta)
        if (key.starts_with(store::others_key)) others[key] = input::parse_number(value).value.value_or(0);
    std::vector<ReportCell> cells;
    for (store::StoredCell& cell : stored) {
        if (!cell.axes.empty()) cell.table += " " + cell.axes;
        std::string label = scene_label(cell);
        const auto share = others.find(store::others_key_of(data.build.id, cell));
        cells.push_back({std::move(cell), std::move(label), share == others.end() ? 0 : share->second});
    }
    std::ranges::sort(cells, [](const ReportCell& a, const ReportCell& b) {
        return std::tie(a.scene, a.scene_parameters, a.vertices, a.shape, a.algorithm, a.table, a.hash) <
               std::tie(b.scene, b.scene_parameters, b.vertices, b.shape, b.algorithm, b.table, b.hash);
    });
    return cells;
}

/// Moves the cells for which `is_one` is true.
template <class IsOne>
std::vector<ReportCell> take_out(std::vector<ReportCell>& cells, IsOne is_one) {
    std::vector<ReportCell> taken;
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(taken), is_one);
    std::erase_if(cells, is_one);
    return taken;
}

/// A cell of a scene file is one of that file's kind, and is called by what the file varies.
void name_by_file(std::vector<ReportCell>& cells, const std::map<std::string, std::string>& files) {
    for (ReportCell& cell : cells) {
        const auto found = files.find(cell.scene);
        if (found == files.end()) continue;
        cell.scene_label = scene_label(cell, found->second);
        cell.scene_kind = input::text_member(input::json_or_null(found->second), "scene");
    }
}

/// Scenes by name, the rows of other runs, and the cells of scenes from files.
void sort_out(ReportData& data) {
    data.scene_files = data.meta_with(store::scene_file_key);
    const std::map<std::string, std::string> files(data.scene_files.begin(), data.scene_files.end());
    const auto of = [](const char* run) { return [run](const ReportCell& cell) { return cell.run == run; }; };
    data.stability = take_out(data.cells, of("stability"));
    data.paging = take_out(data.cells, of("paging"));
    data.thrash = take_out(data.cells, [](const ReportCell& cell) {
        return cell.run == "thrash" || cell.run == "thrash_realised";
    });
    data.effort = take_out(data.cells, of("effort"));
    data.fields = take_out(data.cells, of("fields"));
    data.again =
        take_out(data.cells, [](const ReportCell& cell) { return cell.run.starts_with(store::process_run); });
    data.other_studies =
        take_out(data.cells, [](const ReportCell& cell) { return cell.run != store::sweep_run; });
    data.from_files =
        take_out(data.cells, [&](const ReportCell& cell) { return files.contains(cell.scene); });
    name_by_file(data.from_files, files);
    name_by_file(data.again, files);
    data.peers = take_out(data.cells, [](const ReportCell& cell) { return cell.judged() && !cell.is_raw(); });
}

}  // namespace

std::vector<const ReportCell*> cells_in(std::initializer_list<const std::vector<ReportCell>*> lists) {
    std::vector<const ReportCell*> all;
    for (const auto* list : lists)
        for (const ReportCell& cell : *list) all.push_back(&cell);
    return all;
}

std::size_t ReportData::count(store::CellStatus status) const {
    return static_cast<std::size_t>(std::ranges::count(swept(), status, &ReportCell::status));
}

std::optional<std::string> ReportData::meta_value(std::string_view key) const {
    for (const auto& [name, value] : meta)
        if (name == key) return value;
    return std::nullopt;
}

std::vector<std::pair<std::string, std::string>> ReportData::meta_with(std::string_view key) const {
    std::vector<std::pair<std::string, std::string>> found;
    for (const auto& [name, value] : meta)
        if (name.starts_with(key)) found.emplace_back(name.substr(key.size()), value);
    return found;
}

std::vector<const ReportCell*> ReportData::rows() const {
    return cells_in({&cells, &from_files, &stability, &paging, &thrash, &effort, &fields, &other_studies});
}

std::vector<const ReportCell*> ReportData::rows_and_peers() const {
    std::vector<const ReportCell*> all = rows();
    for (const ReportCell& peer : peers) all.push_back(&peer);
    return all;
}

bool ReportData::any_failed() const {
    return std::ranges::any_of(rows(), [](const ReportCell* row) { return row->failed(); });
}

ReportData read_report(const std::string& store, const std::string& build, const store::OnCell& on_cell) {
    store::StoredBuild stored = store::read_build(store, build, on_cell);
    ReportData data;
    data.meta = std::move(stored.meta);
    data.build = std::move(stored.build);
    data.other_builds = std::move(stored.other_builds);
    data.cells = reader_in_order(std::move(stored.cells), data);
    sort_out(data);
    return data;
}

// The labels of scenes: from a scene's own parameters alone, so that a scene is called the same in every
// store and can be cited. Parameters that are no JSON object are shown as they are.

namespace {

using SceneLabelJson = nlohmann::json;

SceneLabelJson parse_parameters(const std::string& text) {
    SceneLabelJson parsed = input::json_or_null(text);
    if (parsed.is_object()) return parsed;
    return text.empty() ? SceneLabelJson::object() : SceneLabelJson{{"parameters", text}};
}

std::string shown(const SceneLabelJson& value) {
    if (value.is_string()) return value.get<std::string>();
    const double number = value.is_number() ? value.get<double>() : 0.5;
    return std::floor(number) == number ? fmt::format("{:.0f}", number) : value.dump();
}

bool goes_without_saying(const std::string& kind, const std::string& name, const SceneLabelJson& value) {
    static const auto kinds = SceneLabelJson::parse(scene_kind_texts);
    for (const SceneLabelJson& of : kinds)
        for (const SceneLabelJson& parameter : of["parameters"])
            if (of["name"] == kind && parameter["name"] == name)
                return value == parameter["standard"] && !parameter.value("always_said", false);
    return false;
}

std::string label(const std::string& scene, const std::vector<std::string>& inside) {
    return inside.empty() ? scene : fmt::format("{} ({})", scene, fmt::join(inside, ", "));
}

/// The parameter that a scene file varies; empty: none.
std::string varied_by(const SceneLabelJson& file) {
    const SceneLabelJson vary = input::member_of(file, "vary");
    return vary.is_object() && !vary.empty() ? vary.begin().key() : std::string();
}

}  // namespace

std::optional<double> parameter_of(const store::CellRow& cell, const std::string& name) {
    const SceneLabelJson number = input::member_of(input::json_or_null(cell.scene_parameters), name);
    return number.is_number() ? std::optional(number.get<double>()) : std::nullopt;
}

std::string scene_label(const store::CellRow& cell, const std::string& file_text) {
    const SceneLabelJson parameters = parse_parameters(cell.scene_parameters);
    const SceneLabelJson file = input::json_or_null(file_text);
    const std::string varied = varied_by(file);
    if (!varied.empty() && parameters.contains(varied))
        return label(cell.scene, {varied + " " + shown(parameters[varied])});
    if (file.is_object() && varied.empty()) return cell.scene;
    const std::string kind = file.is_object() ? file.value("scene", cell.scene) : cell.scene;
    std::vector<std::string> inside;
    for (const auto& [name, value] : parameters.items())
        if (!goes_without_saying(kind, name, value)) inside.push_back(name + " " + shown(value));
    const bool of_study =
        cell.run != store::sweep_run && !cell.run.starts_with(store::process_run) && cell.scene != cell.run;
    return label(of_study ? cell.run + " " + cell.scene : cell.scene, inside);
}

namespace {

/// Returns "12 bodies" if the scene says how many.
std::string bodies_text(const ReportCell& cell) {
    const auto bodies = parameter_of(cell, "bodies");
    return bodies ? plural(static_cast<std::size_t>(*bodies), "body", "bodies") : "bodies";
}

std::string turn_of(const ReportCell& cell) {
    if (parameter_of(cell, "random_orientation") == 1) return "turn at random in every step";
    const auto turn = parameter_of(cell, "rotation_step");
    return turn ? fmt::format("turn by {:g} rad per step", *turn) : "turn";
}

std::string motion_of(const ReportCell& cell) {
    const std::string kind = scene_kind(cell), bodies = bodies_text(cell);
    if (kind == "static") return fmt::format("{} at rest, every pair new, from sweep and prune", bodies);
    if (kind == "cold") return "independent random pairs, every query new";
    if (kind == "gap") return "independent random pairs at given gaps, every query new";
    if (kind == "tumble")
        return fmt::format("{} drift and {}, pairs followed from step to step", bodies, turn_of(cell));
    if (kind == "proximity") return fmt::format("pairs that stay close and {}", turn_of(cell));
    if (kind == "pressure")
        return fmt::format("{} in a row {}, neighbours asked in turn", bodies, turn_of(cell));
    if (kind == "resting") return bodies + " at rest on each other, most of them nearly still";
    if (kind == "recorded") return "motion of an engine, replayed step after step";
    return kind;
}

}  // namespace

std::string scene_kind(const ReportCell& cell) {
    return cell.scene_kind.empty() ? cell.scene : cell.scene_kind;
}

bool has_own_tables(const ReportCell& cell) {
    if (const auto own = parameter_of(cell, "own_tables")) return *own == 1;
    return scene_kind(cell) == "pressure";
}

bool is_near_contact(const ReportCell& cell) {
    constexpr double widest_gap = 0.01;
    const std::string kind = scene_kind(cell);
    const double gap = parameter_of(cell, "gap").value_or(-1);
    return (kind == "proximity" || (kind == "gap" && parameter_of(cell, "span") == 0)) && gap >= 0 &&
           gap <= widest_gap;
}

std::string scene_sentence(const ReportCell& cell) {
    const std::string kind = scene_kind(cell);
    return fmt::format("{}; {}", motion_of(cell),
                       has_own_tables(cell)                      ? "a table for each body"
                       : kind == "recorded" || kind == "resting" ? "a table for each shape"
                                                                 : "one shared table");
}

std::string Coherence::text() const {
    if (start == Start::fresh) return kind + ", every pair new";
    if (start == Start::random) return kind + ", random turns";
    return turn == 0 ? kind + ", no turn" : fmt::format("{}, {:.1g} rad", kind, turn);
}

std::optional<Coherence> coherence_of(const ReportCell& cell) {
    const std::string kind = scene_kind(cell);
    if (kind == "static" || kind == "cold" || kind == "gap")
        return Coherence{Coherence::Start::fresh, 0, kind};
    if (parameter_of(cell, "random_orientation") == 1) return Coherence{Coherence::Start::random, 0, kind};
    const auto turn = parameter_of(cell, "rotation_step");
    if (!turn || !(*turn >= 0)) return std::nullopt;
    // The nearest power of the root of ten: 0.001, 0.0032, 0.01 ...
    const double nearest = *turn == 0 ? 0 : std::pow(10, std::round(2 * std::log10(*turn)) / 2);
    return Coherence{Coherence::Start::turned, nearest, kind};
}

double distance_from_class(const ReportCell& cell, const Coherence& coherence) {
    if (coherence.turn == 0) return 1;
    const double turn = parameter_of(cell, "rotation_step").value_or(coherence.turn);
    return std::max(turn / coherence.turn, coherence.turn / turn);
}

std::optional<int> tables_class(const ReportCell& cell) {
    if (!has_own_tables(cell)) return -1;
    const auto bodies = parameter_of(cell, "bodies");
    if (!bodies || !(*bodies >= 1)) return std::nullopt;
    int power = 0;
    for (double next = 10; *bodies >= next; next *= 10) ++power;
    return power;
}

std::string tables_class_text(int of) {
    if (of < 0) return "one shared table";
    const double first = std::pow(10, of);
    return fmt::format("{:.0f} to {:.0f} tables", of == 0 ? 2 : first, 10 * first - 1);
}

}  // namespace edgewise::reports
