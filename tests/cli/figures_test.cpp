// SPDX-License-Identifier: MIT
//
// The vocabulary of figures against its page in docs/, and which caches a sweep models.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli_paths.hpp"
#include "program.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json figures(const Folder& folder) {
    const Outcome outcome = run({"list", "figures", "--json"}, folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out).at("figures");
}

/// The page is the source of the vocabulary (cmake/tool.cmake): no row of it is lost or misread.
TEST(Figures, AreDocumented) {
    const Folder folder;
    std::string rows;
    for (const json& figure : figures(folder)) {
        const auto text = [&](const char* key) { return figure.at(key).get<std::string>(); };
        rows += "| `" + text("name") + "` | " + text("unit") + " | " + text("population") + " | " +
                (figure.at("deterministic").get<bool>() ? "yes" : "no") + " | " + text("meaning") + " |\n";
    }
    EXPECT_THAT(text_of(figures_page), testing::EndsWith("|---|---|---|---|---|\n" + rows));
}

TEST(Caches, AreModelledOnceForCellsThatAskForIt) {
    const Folder folder;
    folder.write("mine.json", R"({"what": "mine", "clock_mhz": 1000, "line_bytes": 64,
        "levels": [{"name": "L1D", "bytes": 4096, "ways": 4, "latency_cycles": 4, "source": "me"}],
        "memory": {"latency_cycles": 100, "source": "me"}})");
    Arguments arguments = {
        "sweep",     "--scenes", "tumble,static", "--shapes",   "cube8,sphere38", "--layouts", "aos_f64",
        "--queries", "200",      "--checked",     "20",         "--rounds",       "1",         "--caches",
        "sphere38",  "--store",  "s.db",          "--machines", "zen5,mine.json"};
    ASSERT_EQ(run(arguments, folder).exit_code, 0);
    // Three scenes (plan quick has two of tumble), two algorithms.
    const std::string figure = "from figure join cell using (hash) where shape = ";
    EXPECT_EQ(rows_of(folder / "s.db",
                      "select value " + figure + "'sphere38' and name = 'zen5.L2.misses_per_query'")
                  .size(),
              6U);
    const auto mine = rows_of(
        folder / "s.db", "select value > 0 " + figure + "'sphere38' and name = 'mine.L1D.misses_per_query'");
    EXPECT_THAT(mine, testing::AllOf(testing::SizeIs(6), testing::Contains("1").Times(testing::Ge(3))));
    const auto others = rows_of(folder / "s.db", "select value is null and figure.reason <> '' " + figure +
                                                     "'cube8' and name = 'misses_per_query'");
    EXPECT_THAT(others, testing::AllOf(testing::SizeIs(6), testing::Each(HasSubstr("1"))));
    EXPECT_THAT(text_of(folder / "index.html"),
                testing::AllOf(HasSubstr("zen5: misses, why"), HasSubstr("mine L1D")));
    // A table that is built again takes another time.
    const std::string built = "select hash, value " + figure + "'sphere38' and name = 'build_ns' order by 1";
    const auto first = rows_of(folder / "s.db", built);
    ASSERT_FALSE(first.empty());
    EXPECT_EQ(run(arguments, folder).exit_code, 0);
    EXPECT_EQ(rows_of(folder / "s.db", built), first);
    arguments.back() = "zen4";
    EXPECT_EQ(run(arguments, folder).exit_code, 0);
    EXPECT_NE(rows_of(folder / "s.db", built), first);
}

}  // namespace
}  // namespace edgewise::cli_test
