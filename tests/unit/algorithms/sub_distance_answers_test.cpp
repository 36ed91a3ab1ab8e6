// SPDX-License-Identifier: MIT
//
// GJK's answers with either solver of its sub-distance compared with exact ones: on pairs at gaps that were
// asked for, on both sides of contact, and on the hard families. Of each, the worst error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "edgewise/scene/answer_claim.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/studies/single_cell.hpp"
#include "edgewise/studies/stability/stability.hpp"

namespace edgewise {
namespace {

constexpr SubDistanceSolver both_solvers[] = {SubDistanceSolver::cofactors, SubDistanceSolver::johnson};

struct Regimes {
    int separated = 0, touching = 0, overlapping = 0;
    int wrong = 0;
    double whole_error = 0;  ///< the worse solver's, over the scale: noisy rotations are a part of it
    double error = 0;        ///< beyond what rotations and contact excuse
    double apart = 0;        ///< of one solver's distance from the other's, over the scale
    int other_bits = 0;      ///< answers in which the solvers differ

    void see(truth::ExactVerdict verdict) {
        separated += verdict == truth::ExactVerdict::separated;
        touching += verdict == truth::ExactVerdict::touching;
        overlapping += verdict == truth::ExactVerdict::overlapping;
    }
};

/// One case of a family, all poses in a row, with both solvers.
void ask_case(const bench::TableType& type, studies::StabilityCases& cases, std::size_t index, bool warm,
              Regimes& seen) {
    const studies::StabilityCase& given = cases.all()[index];
    scene::Workload workload;
    workload.bodies = {given.a, given.b};
    workload.pair_count = 1;
    workload.warm = warm;
    for (const auto& [pose_a, pose_b] : given.poses) workload.queries.push_back({0, 1, 0, pose_a, pose_b});
    std::vector<std::vector<Distance>> answers;
    std::vector<Polyhedron> stored;
    for (const SubDistanceSolver solver : both_solvers) {
        const auto runner = type.make_runner("gjk");
        runner->configure({.query = {.sub_distance = solver}});
        if (!runner->load(workload).empty()) return;
        answers.push_back(runner->answer());
        stored.assign(runner->stored_bodies().begin(), runner->stored_bodies().end());
    }
    for (std::size_t pose = 0; pose < given.poses.size(); ++pose) {
        const truth::PlacedBodies placed = cases.placed({index, pose}, stored);
        const truth::AccuracyBand band = placed.band(type.eps);
        seen.see(cases.known({index, pose}).exact(placed).verdict);
        for (const auto& of_solver : answers) {
            const truth::CheckedAnswer checked =
                truth::check(scene::claim_of(of_solver[pose]), placed, cases.known({index, pose}), band, {});
            seen.wrong += checked.verdict_wrong;
            seen.whole_error = std::max(seen.whole_error, band.over_scale(checked.error));
            seen.error = std::max(seen.error, band.beyond(checked.error));
        }
        const double difference = std::abs(answers[0][pose].distance - answers[1][pose].distance);
        if (band.scale > 0) seen.apart = std::max(seen.apart, difference / band.scale);
        seen.other_bits += difference != 0 || answers[0][pose].point_a != answers[1][pose].point_a;
    }
}

void ask_families(const char* table) {
    const bench::TableType& type = bench::table_type_called(table);
    const std::vector<Polyhedron> bodies = {*scene::make_shape("cube8"), *scene::make_shape("sphere38")};
    Regimes all;
    for (const scene::HardFamily& family : scene::hard_families()) {
        studies::StabilityCases cases(family, 60, 11, type.storage == "single", bodies);
        Regimes seen;
        for (std::size_t i = 0; i < cases.all().size(); ++i) ask_case(type, cases, i, family.warm, seen);
        EXPECT_EQ(seen.wrong, 0) << family.name;
        EXPECT_LE(seen.error, truth::allowed_errors(type.eps).distance) << family.name;
        EXPECT_LE(seen.apart, 2 * truth::allowed_errors(type.eps).distance) << family.name;
        all.error = std::max(all.error, seen.error);
        all.whole_error = std::max(all.whole_error, seen.whole_error);
        all.apart = std::max(all.apart, seen.apart);
        all.separated += seen.separated;
        all.touching += seen.touching;
        all.overlapping += seen.overlapping;
        all.other_bits += seen.other_bits;
    }
    std::printf(
        "%s: %d separated, %d touching, %d overlapping; worst error %.3g, %.3g beyond the band; solvers %.3g apart, other bits in %d\n",
        table, all.separated, all.touching, all.overlapping, all.whole_error, all.error, all.apart,
        all.other_bits);
    EXPECT_GT(all.separated, 500);
    EXPECT_GT(all.touching, 10);
    EXPECT_GT(all.overlapping, 200);
}

TEST(SubDistanceAnswers, AreRightOnTheHardFamiliesInDouble) { ask_families("aos_f64"); }

TEST(SubDistanceAnswers, AreRightOnTheHardFamiliesInSingle) { ask_families("lean_f32"); }

struct Checked {
    int separated = 0, contact = 0;
    double error = 0;
};

/// Checks a cell as a sweep does.
Checked checked_cell(SubDistanceSolver solver, const std::string& table, const scene::SceneParameters& gaps) {
    const studies::SingleCell cell({.table = table,
                                    .algorithm = "gjk",
                                    .scene = "gap",
                                    .shape = "sphere38",
                                    .parameters = gaps,
                                    .queries = 2000,
                                    .sub_distance = solver,
                                    .checked = 500});
    const sweep::PreparedCell& found = cell.prepared();
    EXPECT_EQ(found.wrong(), "") << table;
    Checked checked;
    for (const auto& result : found.checked()) {
        checked.error = std::max(checked.error, result.band.over_scale(result.error));
        ++(result.exact == truth::ExactVerdict::separated ? checked.separated : checked.contact);
    }
    return checked;
}

TEST(SubDistanceAnswers, AreRightAtEveryGap) {
    for (const char* table : {"aos_f64", "lean_f32"}) {
        for (const SubDistanceSolver solver : both_solvers) {
            const Checked spread = checked_cell(solver, table, {}),
                          contact = checked_cell(solver, table, {{"gap", 0}, {"span", 0}});
            std::printf("%s %s: %d separated, %d in contact; worst error %.3g, at no gap %.3g\n", table,
                        std::string(to_string(solver)).c_str(), spread.separated, spread.contact,
                        spread.error, contact.error);
            EXPECT_GT(spread.separated, 100);
            EXPECT_GT(spread.contact, 20);
        }
    }
}

}  // namespace
}  // namespace edgewise
