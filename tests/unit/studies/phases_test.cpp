// SPDX-License-Identifier: MIT
//
// How counts are divided by phase: by the frames of an instruction, by the calls of a function that is not
// inlined, and that nothing is lost.
#include "edgewise/studies/phases/phases.hpp"

#include <gmock/gmock.h>

namespace edgewise::studies {
namespace {

using measure::InlineFrame;
using testing::HasSubstr;
using testing::IsEmpty;

InlineFrame frame(const char* function, const std::string& file) {
    return {function, "/somewhere/build/../src/edgewise/" + file};
}
const InlineFrame product = frame("dot", "geometry/vec.hpp");
const InlineFrame eigen{"coeff", "/usr/include/eigen3/Eigen/src/Core/DenseCoeffsBase.h"};
const InlineFrame advance = frame("advance", "algorithms/gjk.hpp");
const InlineFrame starts = frame("start", "algorithms/gjk_start.hpp");

TEST(Phases, ArithmeticBelongsToWhoAsksForIt) {
    const auto climb = phase_of({eigen, product, frame("climb_support", "algorithms/support.hpp"), advance});
    EXPECT_EQ(climb.phase, "support: climb");
    EXPECT_EQ(climb.recurrence, Recurrence::step);
    const auto cold = phase_of({product, frame("cold_support", "algorithms/support.hpp"), starts});
    EXPECT_EQ(cold.phase, "support: climb");
    EXPECT_EQ(cold.recurrence, Recurrence::once);
    EXPECT_EQ(phase_of({product, frame("vertex_edge", "algorithms/vclip/vertex_edge.hpp")}).phase,
              "state V-E");
    EXPECT_FALSE(phase_of({eigen, product}).phase) << "called by whom?";
}

TEST(Phases, WhatNobodyKnowsIsOther) {
    const auto found = phase_of({product, frame("f", "algorithms/tomorrow.hpp"), advance});
    EXPECT_EQ(found.phase, other_phase);
    EXPECT_EQ(found.place, "algorithms/tomorrow.hpp");
    EXPECT_EQ(found.recurrence, Recurrence::step);
    EXPECT_EQ(phase_of({{"main", "??"}}).place, "main, without a line table");
}

/// Function 0 is GJK's run, 1 the sub-distance, 2 a product, 3 a library's.
measure::CallgrindLines gjk_lines() {
    measure::CallgrindLines lines;
    lines.functions = {"run_gjk", "find_closest", "dot", "memcpy"};
    lines.objects = {"/bin/sim", "/lib/libc"};
    lines.lines = {{0x10, 0, 0, {100, 1, 2}}, {0x14, 0, 0, {50, 0, 0}}, {0x20, 1, 0, {300, 5, 0}},
                   {0x30, 2, 0, {40, 0, 1}},  {0x40, 3, 1, {10, 0, 0}}, {0x18, 0, 0, {7, 0, 0}}};
    lines.calls = {{{0x10, 0, 0, {255, 0, 0}}, 1},
                   {{0x14, 0, 0, {85, 0, 0}}, 1},
                   {{0x20, 1, 0, {40, 0, 1}}, 2},
                   {{0x14, 0, 0, {10, 0, 0}}, 3}};
    lines.total = {507, 6, 3};
    return lines;
}
const measure::InlineFrames gjk_frames = {{0x10, {advance}},
                                          {0x14, {starts}},
                                          {0x18, {frame("f", "algorithms/tomorrow.hpp"), advance}},
                                          {0x20, {frame("find_closest", "algorithms/cofactors.hpp")}},
                                          {0x30, {product}}};

/// Three quarters of the sub-distance's cost come from the iterations; the product is the sub-distance's
/// alone.
TEST(PhaseCounts, CallsTellWhatFramesDoNot) {
    const PhaseCounts counts = divide_by_phase(gjk_lines(), gjk_frames, "/bin/sim");
    const PhaseCost& sub_distance = counts.phases.at("sub-distance");
    EXPECT_EQ(sub_distance.cost.instructions, 340U);
    EXPECT_DOUBLE_EQ(sub_distance.in_steps, 0.75 * 340);
    EXPECT_DOUBLE_EQ(counts.phases.at("start").in_steps, 0);
    EXPECT_DOUBLE_EQ(counts.phases.at("GJK: loop, duality gap").in_steps, 100);
    EXPECT_EQ(counts.phases.at("C library").cost.instructions, 10U);
    EXPECT_EQ(counts.phases.at("other").cost.instructions, 7U);
    EXPECT_EQ(counts.others.at("algorithms/tomorrow.hpp"), 7U);
}

TEST(PhaseCounts, AFunctionOfSeveralPhasesIsShared) {
    measure::CallgrindLines lines = gjk_lines();
    lines.calls.push_back({{0x14, 0, 0, {40, 0, 0}}, 2});
    EXPECT_EQ(divide_by_phase(lines, gjk_frames, "/bin/sim").phases.count("arithmetic, shared"), 1U);
}

TEST(PhaseCounts, NothingIsLost) {
    const measure::CallgrindLines lines = gjk_lines();
    const PhaseCounts counts = divide_by_phase(lines, gjk_frames, "/bin/sim");
    EXPECT_EQ(check_sum(counts, lines.total), "");
    EXPECT_THAT(check_sum(counts, {508, 6, 3}), HasSubstr("507 instructions"));
    EXPECT_THAT(check_sum(counts, {507, 6, 4}), HasSubstr("Callgrind to 507, 6 and 4"));
    EXPECT_EQ(check_sum(divide_by_phase(lines, {}, "/bin/sim"), lines.total), "") << "all of it in other";
    EXPECT_THAT(addresses_in(lines, "/bin/nothing"), IsEmpty());
}

/// 500 before the passes, then 20 queries of 30 instructions, 10 of them in steps.
TEST(PhaseCounts, ArePerQueryAsDifferencesOfPasses) {
    const auto counted = [](std::uint64_t passes) {
        PhaseCounts counts;
        counts.phases["start"] = {{500 + passes * 600, 3 + passes * 40, 2 + passes * 20},
                                  static_cast<double>(passes) * 200};
        return counts;
    };
    PhaseCounts many = counted(3);
    many.phases["sub-distance"].cost.instructions = 4000;
    const auto phases = phases_per_query(counted(1), many, 2, 20);
    ASSERT_EQ(phases.size(), 2U);
    EXPECT_EQ(phases[0].phase, "sub-distance");
    EXPECT_DOUBLE_EQ(phases[0].instructions, 100);
    EXPECT_DOUBLE_EQ(phases[1].instructions, 30);
    EXPECT_DOUBLE_EQ(phases[1].mispredictions, 2);
    EXPECT_DOUBLE_EQ(phases[1].d1_misses, 1);
    EXPECT_DOUBLE_EQ(phases[1].instructions_in_steps, 10);
}

}  // namespace
}  // namespace edgewise::studies
