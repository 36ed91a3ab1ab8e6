// SPDX-License-Identifier: MIT
//
// If memory for the tables runs out, the cell is unavailable, with that reason: it did not fail its check.
#include <gmock/gmock.h>

#include "edgewise/input/guarded.hpp"
#include "edgewise/sweep/cell_run.hpp"

namespace edgewise::sweep {
namespace {

/// "verified: " or what else became of a cell that was verified with so much memory more than there is.
std::string verified_within(std::uint64_t bytes) {
    const scene::NamedShape shape{"cube8", "built-in", *scene::make_shape("cube8"), {}};
    Plan plan;
    plan.queries = 40;
    plan.checked = 10;
    SharedQueries shared(plan, {"cold"}, shape);
    store::CellRow row;
    row.scene = "cold";
    row.shape = shape.name;
    CellRun cell(bench::table_types().front(), "vclip", {}, row, shape.body);
    const auto said = input::run_guarded(
        [&] {
            cell.verify(shared);
            return std::string(to_string(cell.row().status)) + ": " + cell.row().reason;
        },
        {bytes, std::chrono::seconds(60)});
    return said ? *said : said.error;
}

TEST(CellMemory, ThatLacksMakesItUnavailable) {
    EXPECT_EQ(verified_within(std::uint64_t{64} << 30), "verified: ");
    EXPECT_EQ(verified_within(std::uint64_t{1} << 30), "verified: ") << "tables ask for what they need";
    EXPECT_THAT(verified_within(std::uint64_t{1} << 20),
                testing::StartsWith("unavailable: tables: no address space for 2 MiB of tables"));
}

}  // namespace
}  // namespace edgewise::sweep
