// SPDX-License-Identifier: MIT
//
// Medians and ratios of pairs from known times; and one body of a layout really at many scales, whose answers
// over one table are those over a table each.
#include "edgewise/probes/scale.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/bench/scales/scale_study.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/scene/shapes.hpp"
#include "found.hpp"

namespace edgewise::probes {
namespace {

TEST(Scale, IsMediansAndTheRatioIsOfPairs) {
    bench::ScaleTimes times;
    times.shared_ns = {100, 300, 200, 210, 205, 206, 207};
    times.own_ns = {200, 300, 400, 420, 410, 412, 414};
    times.build_ns = {3, 1, 2};
    auto found = by_name(scale::figures(times));
    EXPECT_EQ(found["shared_query_ns"].value, 206);
    EXPECT_EQ(found["shared_over_own"].value, 0.5) << "of 0.5, 1, 0.5 and so on";
    EXPECT_EQ(found["shared_over_own_low"].value, 0.5);
    EXPECT_EQ(found["build_ns"].value, 2);
    EXPECT_FALSE(found["refit_ns"].value);
}

template <class Table>
bench::ScaleTimes study_of(const char* shape) {
    const Polyhedron body = stored_body<Table>(scene::make_shape(shape).or_throw()).or_throw();
    const bench::ScaleTimes times = bench::ScaleStudy<Table>(body).run(2);
    std::printf("%s of %s: %zu queries, %zu of other bits, worst error %.2g of %zu checked\n",
                std::string(Table::name).c_str(), shape, times.queries, times.other_bits, times.error,
                times.checked);
    return times;
}

TEST(Scale, OneTableAnswersAsATableEachAndExactly) {
    const bench::ScaleTimes in_double = study_of<lean<f64>>("sphere102"),
                            in_single = study_of<lean<f32>>("sphere102");
    for (const bench::ScaleTimes* times : {&in_double, &in_single}) {
        EXPECT_EQ(times->queries, 1536U);
        EXPECT_EQ(times->other_bits, 0U);
        EXPECT_GE(times->checked, 128U);
        EXPECT_LT(times->shared_bytes * 20, times->own_bytes);
    }
    EXPECT_LT(in_double.error, verified_error_double);
    EXPECT_LT(in_single.error, verified_error_single);
}

}  // namespace
}  // namespace edgewise::probes
