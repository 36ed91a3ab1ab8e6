// SPDX-License-Identifier: MIT
//
// Raw V-Clip: where hardened V-Clip did not ask GJK, both answers are the same to the last bit. Their steps
// may differ: hardened V-Clip starts cold queries nearer, and after contact the two may be at different
// features. Where hardened V-Clip asked GJK, raw V-Clip still ends; in hard families raw V-Clip is wrong.
#include <gmock/gmock.h>

#include <cstdio>
#include <map>

#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/studies/stability/stability.hpp"

namespace edgewise::studies {
namespace {

const bench::TableType& raw_table() {
    return *bench::select_table_types(std::vector<std::string>{raw_type}).front();
}

std::vector<Distance> answers_of(const scene::Workload& workload, bool hardened) {
    const auto runner = raw_table().make_runner("vclip");
    runner->configure({.query = {.hardened = hardened}});
    EXPECT_EQ(runner->load(workload), "");
    return runner->answer();
}

TEST(RawVClip, IsTheHardenedOneWhereThatAsksNobody) {
    std::size_t alike = 0, asked = 0;
    for (const char* shape : {"cube8", "sphere386"}) {
        const auto workload = scene::make_scene("tumble", scene::make_shape(shape).or_throw(),
                                                {{"rotation_step", 0.3}}, 1, 4000, {})
                                  .or_throw();
        const auto hard = answers_of(workload, true), raw = answers_of(workload, false);
        bool same_start = true;  // an answer of GJK's leaves other features to start from
        for (std::size_t i = 0; i < hard.size(); ++i) {
            EXPECT_EQ(raw[i].fallbacks + raw[i].refinements, 0);
            const bool by_itself = hard[i].fallbacks + hard[i].refinements == 0;
            asked += !by_itself;
            same_start = same_start && by_itself;
            if (!same_start) continue;
            ++alike;
            EXPECT_EQ(raw[i].status, hard[i].status) << shape << " " << i;
            EXPECT_EQ(raw[i].distance, hard[i].distance) << shape << " " << i;
        }
    }
    std::printf("%zu identical answers, %zu that asked GJK\n", alike, asked);
    EXPECT_GT(alike, 1000U);
}

TEST(RawVClip, IsWrongOnHardFamiliesWhereTheHardenedOneIsRight) {
    StabilityPlan plan;
    plan.count = 30;
    plan.proofs = 0;
    plan.types = {&raw_table()};
    plan.algorithms = {"vclip"};
    plan.raw = true;
    std::map<std::string, double> wrong;
    std::size_t judged = 0;
    const std::atomic<bool> go_on = false;
    const StabilitySummary summary = run_stability(
        plan,
        [&](const StabilityRow& row) {
            const bool raw = row.cell.axes == "hardening=off";
            EXPECT_TRUE(raw || row.cell.status != store::CellStatus::judged);
            judged += row.cell.status == store::CellStatus::judged;
            for (const store::FigureRow& figure : row.figures)
                if (figure.name == "wrong_outside_band" || figure.name == "errors_beyond")
                    wrong[raw ? "raw" : "hardened"] += figure.value.value_or(0);
        },
        go_on);
    std::printf("wrong answers: raw %g, hardened %g\n", wrong["raw"], wrong["hardened"]);
    EXPECT_EQ(summary.failed, 0U);
    EXPECT_EQ(summary.rows, stability_rows(plan));
    EXPECT_GT(judged, 0U);
    EXPECT_GT(wrong["raw"], 0);
    EXPECT_EQ(wrong["hardened"], 0);
}

}  // namespace
}  // namespace edgewise::studies
