// SPDX-License-Identifier: MIT
#include "edgewise/reports/reader.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/scene_label.hpp"
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

std::vector<ReportCell> reader_in_order(std::vector<store::StoredCell> stored) {
    std::vector<ReportCell> cells;
    for (store::StoredCell& cell : stored) {
        if (!cell.axes.empty()) cell.table += " " + cell.axes;
        std::string label = scene_label(cell);
        cells.push_back({std::move(cell), std::move(label)});
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
void name_by_file(std::vector<ReportCell>& cells,
                  const std::vector<std::pair<std::string, std::string>>& scene_files) {
    std::map<std::string, const std::string*> texts;
    for (const auto& [name, text] : scene_files) texts[name] = &text;
    for (ReportCell& cell : cells) {
        const std::string& text = *texts.at(cell.scene);
        cell.scene_label = scene_label(cell, text);
        const auto json = input::json_or_null(text);
        if (json.is_object() && json.contains("scene") && json["scene"].is_string())
            cell.scene_kind = json["scene"];
    }
}

/// Scenes by name, the rows of other runs, and the cells of scenes from files.
void sort_out(ReportData& data) {
    const std::string prefix = store::scene_file_key;
    std::set<std::string> names;
    for (const auto& [key, value] : data.meta) {
        if (key.rfind(prefix, 0) != 0) continue;
        data.scene_files.emplace_back(key.substr(prefix.size()), value);
        names.insert(data.scene_files.back().first);
    }
    const auto of = [](const char* run) { return [run](const ReportCell& cell) { return cell.run == run; }; };
    data.stability = take_out(data.cells, of("stability"));
    data.paging = take_out(data.cells, of("paging"));
    data.thrash = take_out(data.cells, [](const ReportCell& cell) {
        return cell.run == "thrash" || cell.run == "thrash_realised";
    });
    data.effort = take_out(data.cells, of("effort"));
    data.fields = take_out(data.cells, of("fields"));
    data.other_studies =
        take_out(data.cells, [](const ReportCell& cell) { return cell.run != store::sweep_run; });
    data.from_files =
        take_out(data.cells, [&](const ReportCell& cell) { return names.contains(cell.scene); });
    name_by_file(data.from_files, data.scene_files);
    const auto is_peer = [](const ReportCell& cell) { return cell.judged() && !cell.is_raw(); };
    std::copy_if(data.cells.begin(), data.cells.end(), std::back_inserter(data.peers), is_peer);
    std::erase_if(data.cells, is_peer);
}

}  // namespace

std::vector<const ReportCell*> ReportData::swept() const {
    std::vector<const ReportCell*> all;
    for (const auto* from : {&cells, &from_files})
        for (const ReportCell& cell : *from) all.push_back(&cell);
    return all;
}

std::size_t ReportData::count(store::CellStatus status) const {
    const auto has_it = [&](const ReportCell& cell) { return cell.status == status; };
    return static_cast<std::size_t>(std::ranges::count_if(cells, has_it) +
                                    std::ranges::count_if(from_files, has_it));
}

std::optional<std::string> ReportData::meta_value(std::string_view key) const {
    for (const auto& [name, value] : meta)
        if (name == key) return value;
    return std::nullopt;
}

bool ReportData::any_failed() const {
    const auto failed = [](const ReportCell& row) { return row.failed(); };
    return count(store::CellStatus::failed) > 0 || std::ranges::any_of(stability, failed) ||
           std::ranges::any_of(effort, failed) || std::ranges::any_of(fields, failed) ||
           std::ranges::any_of(other_studies, failed);
}

ReportData read_report(const std::string& store, const std::string& build, const store::OnCell& on_cell) {
    store::StoredBuild stored = store::read_build(store, build, on_cell);
    ReportData data;
    data.meta = std::move(stored.meta);
    data.build = std::move(stored.build);
    data.other_builds = std::move(stored.other_builds);
    data.cells = reader_in_order(std::move(stored.cells));
    sort_out(data);
    return data;
}

}  // namespace edgewise::reports
