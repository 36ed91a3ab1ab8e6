// SPDX-License-Identifier: MIT
#include "edgewise/studies/stability.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "edgewise/bench/cell.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/studies/stability_subject.hpp"

namespace edgewise::studies {

namespace {

std::vector<const scene::HardFamily*> chosen_families(const StabilityPlan& plan) {
    std::vector<const scene::HardFamily*> result;
    std::vector<std::string> names;
    for (const scene::HardFamily& family : scene::hard_families()) {
        names.push_back(family.name);
        if (plan.families.empty()) result.push_back(&family);
    }
    for (const std::string& name : plan.families) {
        const auto found = std::ranges::find(scene::hard_families(), name, &scene::HardFamily::name);
        if (found == scene::hard_families().end())
            throw std::invalid_argument(unknown_name("family", name, names));
        result.push_back(&*found);
    }
    return result;
}

/// One algorithm on one table type.
struct Subject {
    const bench::TableType* type;
    std::string algorithm;
    bool raw = false;
};

std::vector<Subject> subjects_of(const StabilityPlan& plan) {
    std::vector<Subject> subjects;
    for (const bench::TableType* type : plan.types) {
        for (const std::string& algorithm : plan.algorithms) {
            if (!type->serves(algorithm)) continue;
            subjects.push_back({type, algorithm});
            if (plan.raw && algorithm == "vclip" && type->name == raw_type)
                subjects.push_back({type, algorithm, true});
        }
    }
    return subjects;
}

StabilityRow row_for(const StabilityPlan& plan, const scene::HardFamily& family, const Subject& subject) {
    const bench::TableType& type = *subject.type;
    StabilityRow row;
    row.cell.run = store::Run::stability;
    row.cell.scene = to_string(row.cell.run);
    row.cell.scene_parameters = bench::parameters_json({{"count", static_cast<double>(plan.count)}});
    row.cell.shape = family.name;
    row.cell.shape_source = "generated";
    row.cell.algorithm = subject.algorithm;
    if (subject.raw) row.cell.axes = "hardening=off";
    row.cell.layout = type.layout;
    row.cell.precision = type.precision;
    row.cell.table = type.name;
    row.cell.seed = plan.seed;
    row.cell.queries = plan.count;
    bench::name_cell(row.cell, Polyhedron{});
    return row;
}

/// By storage of the bodies: exact answers are shared.
using SharedCases = std::map<std::string, StabilityCases>;

/// Raw V-Clip is judged: what is wrong with it fails nothing, and nothing of it is proven.
StabilityRow measured_row(const StabilityPlan& plan, const scene::HardFamily& family, const Subject& subject,
                          SharedCases& cases) {
    StabilityRow row = row_for(plan, family, subject);
    if (auto stored = plan.stored ? plan.stored(row.cell.hash) : std::nullopt) return *std::move(stored);
    if (family.name == real_family && plan.real.empty()) {
        row.cell.status = store::CellStatus::unavailable;
        row.cell.reason = "no real meshes here: name some with --shape";
        return row;
    }
    const bench::TableType& type = *subject.type;
    StabilityTally tally;
    const auto of_storage =
        cases.try_emplace(type.storage, family, plan.count, plan.seed, type.single_storage, plan.real);
    StabilitySubject asked(type, subject.algorithm, family.warm, of_storage.first->second,
                           subject.raw ? 0 : plan.proofs);
    if (subject.raw) asked.make_raw();
    asked.run(tally);
    for (measure::Figure& figure : tally.figures()) row.figures.push_back({std::move(figure), "stability"});
    row.cell.reason = tally.what_is_wrong();
    row.cell.status = subject.raw               ? store::CellStatus::judged
                      : row.cell.reason.empty() ? store::CellStatus::verified
                                                : store::CellStatus::failed;
    return row;
}

}  // namespace

std::size_t stability_rows(const StabilityPlan& plan) {
    return subjects_of(plan).size() * chosen_families(plan).size();
}

StabilitySummary run_stability(const StabilityPlan& plan,
                               const std::function<void(const StabilityRow&)>& on_row,
                               const std::atomic<bool>& stop) {
    StabilitySummary summary;
    for (const scene::HardFamily* family : chosen_families(plan)) {
        SharedCases cases;
        for (const Subject& subject : subjects_of(plan)) {
            summary.stopped = stop;
            if (summary.stopped) return summary;
            const StabilityRow row = measured_row(plan, *family, subject, cases);
            ++summary.rows;
            summary.failed += row.cell.failed();
            summary.unavailable += row.cell.status == store::CellStatus::unavailable;
            on_row(row);
        }
    }
    return summary;
}

}  // namespace edgewise::studies
