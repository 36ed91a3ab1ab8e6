// SPDX-License-Identifier: MIT
//
// The first look of an advice: all cells of the program, each in or out for what it is, whatever they take.
#include "edgewise/studies/advise/screen.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

namespace edgewise::studies::advise {
namespace {

using testing::HasSubstr;

CaseAsked three_spheres(double error_limit) {
    CaseAsked asked;
    asked.shape = {"sphere386", "built-in", *scene::make_shape("sphere386"), {}};
    asked.scene = tumbling(3, 0.1);
    asked.error_limit = error_limit;
    return asked;
}

constexpr ScreenOptions short_look{.queries = 60, .checked = 6, .passes = 1, .slowest = 1e9};

Screen look(double error_limit, const ScreenOptions& options = short_look) {
    return screen(three_spheres(error_limit), options, [] { return false; });
}

std::size_t cells_of_program() {
    std::size_t cells = 0;
    for (const bench::TableType& type : bench::table_types()) cells += type.algorithms.size();
    return cells;
}

/// Returns the number of cells with layouts for bodies of fewer vertices; not every build has such layouts.
std::size_t cells_that_refuse(const Polyhedron& body) {
    std::size_t cells = 0;
    for (const bench::TableType& type : bench::table_types())
        if (!type.stored_body(body)) cells += type.algorithms.size();
    return cells;
}

TEST(Screen, LooksAtEachCellOnceAndSaysWhyItIsOut) {
    const double limit = 1e-9;
    const Screen seen = look(limit);
    EXPECT_EQ(seen.left_out, 0U);
    std::set<std::string> names;
    std::map<DroppedFor, std::size_t> count;
    double worst_double = 0, least_single = 1;
    for (const ScreenedCell& cell : seen.cells) {
        names.insert(cell.name());
        ++count[cell.dropped_for];
        EXPECT_EQ(cell.is_in(), cell.dropped.empty()) << cell.name();
        if (cell.dropped_for == DroppedFor::failure) continue;
        EXPECT_EQ(cell.dropped_for == DroppedFor::error, cell.error > limit) << cell.name() << cell.error;
        if (cell.dropped_for == DroppedFor::error) {
            EXPECT_THAT(cell.dropped, HasSubstr("is over 1e-09"));
        }
        if (cell.type->storage == "double") worst_double = std::max(worst_double, cell.error);
        if (cell.type->precision == "f32") least_single = std::min(least_single, cell.error);
        EXPECT_GT(cell.ns, 0);
        EXPECT_DOUBLE_EQ(cell.bytes_per_edge * 1152, cell.table_bytes);
    }
    EXPECT_EQ(names.size(), cells_of_program());
    EXPECT_EQ(seen.cells.size(), cells_of_program());
    std::printf("worst error of double %.2g, least of single %.2g\n", worst_double, least_single);
    EXPECT_LT(worst_double, 1e-12);
    EXPECT_GT(least_single, 1e-9);
    EXPECT_GT(count[DroppedFor::nothing], 5U);
    EXPECT_GT(count[DroppedFor::error], 5U);
    EXPECT_EQ(count[DroppedFor::failure], cells_that_refuse(three_spheres(limit).shape.body));
    EXPECT_EQ(count[DroppedFor::time], 0U);
}

TEST(Screen, PutsWhoIsInFirstAndTheFastestBeforeOthers) {
    const Screen seen = look(1e-9);
    EXPECT_TRUE(std::ranges::is_sorted(
        seen.cells, {}, [](const ScreenedCell& cell) { return std::pair(!cell.is_in(), cell.ns); }));
    EXPECT_TRUE(seen.cells.front().is_in());
}

TEST(Screen, LetsAllInThatALargeErrorAllows) {
    for (const ScreenedCell& cell : look(1).cells)
        EXPECT_NE(cell.dropped_for, DroppedFor::error) << cell.name();
}

/// Only the fastest cell is left, with the baseline and cells with the same time as the fastest.
TEST(Screen, LeavesOutWhoIsSlowerThanAllowedButNotTheBaseline) {
    ScreenOptions strict = short_look;
    strict.slowest = 1;
    const Screen seen = look(1e-9, strict);
    const double fastest = seen.cells.front().ns;
    int slow = 0;
    for (const ScreenedCell& cell : seen.cells) {
        if (cell.is_in() && !cell.is_baseline()) {
            EXPECT_EQ(cell.ns, fastest) << cell.name();
        }
        if (cell.dropped_for != DroppedFor::time) continue;
        ++slow;
        EXPECT_GT(cell.ns, fastest) << cell.name();
        EXPECT_FALSE(cell.is_baseline());
        EXPECT_THAT(cell.dropped, HasSubstr("times as long as the fastest"));
    }
    EXPECT_GT(slow, 5);
}

TEST(Screen, BeginsWithTheBaselineAndEndsWithVariantsWhereItIsStopped) {
    for (const std::size_t most : {std::size_t{0}, std::size_t{1}, std::size_t{9}}) {
        std::size_t asked = 0;
        const Screen seen = screen(three_spheres(1e-6), short_look, [&] { return asked++ == most; });
        EXPECT_EQ(seen.cells.size(), most);
        EXPECT_EQ(seen.left_out, cells_of_program() - most);
        EXPECT_EQ(std::ranges::count_if(seen.cells, &ScreenedCell::is_baseline), most > 0 ? 1 : 0);
        for (const ScreenedCell& cell : seen.cells) EXPECT_TRUE(cell.type->variant_of.empty());
    }
}

}  // namespace
}  // namespace edgewise::studies::advise
