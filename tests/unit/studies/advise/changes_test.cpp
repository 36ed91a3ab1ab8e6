// SPDX-License-Identifier: MIT
//
// Sentences on how another question would change an advice: each appears if and only if it is true.
#include "edgewise/studies/advise/screen.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace edgewise::studies::advise {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

ScreenedCell looked_at(const std::string& table, double ns, double bytes = 10,
                       DroppedFor dropped_for = DroppedFor::nothing, double error = 0) {
    ScreenedCell cell;
    cell.type = bench::select_table_types(std::vector{table}).front();
    cell.algorithm = "vclip";
    cell.ns = ns;
    cell.bytes_per_edge = bytes;
    cell.error = error;
    cell.dropped_for = dropped_for;
    return cell;
}

Taken taken_lean(double error = 0) { return {"V-Clip on lean_f64", 12.8, error}; }

const std::string one_table = "one table for all bodies: ",
                  shared_best = "V-Clip on aos_f64, 290 ns at a first look";

TEST(AdviceChanges, AreNoneWhereNothingWould) {
    EXPECT_THAT(what_would_change({}, {}, {}, taken_lean()), IsEmpty());
}

TEST(AdviceChanges, NameTheFastestWithTablesSharedTheOtherWay) {
    CaseAsked asked;
    asked.own_tables = true;
    const ScreenedCell aos = looked_at("aos_f64", 290), lean = looked_at("lean_f64", 600),
                       other = looked_at("hot_cold_f64", 300);
    EXPECT_THAT(what_would_change(asked, {}, {aos, lean}, taken_lean()),
                ElementsAre(one_table + shared_best + "; V-Clip on lean_f64 then takes 600 ns"));
    EXPECT_THAT(what_would_change(asked, {}, {aos, other}, taken_lean()),
                ElementsAre(one_table + shared_best + "; V-Clip on lean_f64 is then dropped"));
    EXPECT_THAT(what_would_change(asked, {}, {lean, aos}, taken_lean()),
                ElementsAre(one_table + "V-Clip on lean_f64, 600 ns at a first look"));
    asked.own_tables = false;
    EXPECT_THAT(
        what_would_change(asked, {}, {aos, other}, taken_lean()),
        ElementsAre("a table for each body: " + shared_best + "; V-Clip on lean_f64 is then dropped"));
}

TEST(AdviceChanges, NameTheCellThatALargerErrorAllows) {
    Screen screen;
    screen.cells = {looked_at("lean_f64", 700, 12.8),
                    looked_at("linked_f64", 500, 138, DroppedFor::error, 1e-7),
                    looked_at("points_soa_f64", 600, 5, DroppedFor::failure, 1),
                    looked_at("lean_f32", 650, 5, DroppedFor::time, 1e-17),
                    looked_at("quantised_f64", 819, 6.8, DroppedFor::error, 1.1e-5)};
    EXPECT_THAT(
        what_would_change({}, screen, {}, taken_lean()),
        ElementsAre("an error of 1.1e-05 allowed: V-Clip on quantised_f64 becomes possible (6.8 bytes per "
                    "edge, 819 ns)"))
        << "not a larger, wrong or slow cell";
}

TEST(AdviceChanges, NameTheErrorBelowWhichTheTakenGoes) {
    EXPECT_THAT(what_would_change({}, {}, {}, taken_lean(8.2e-8)),
                ElementsAre("an error below 8.2e-08 asked for: V-Clip on lean_f64 is dropped"));
}

}  // namespace
}  // namespace edgewise::studies::advise
