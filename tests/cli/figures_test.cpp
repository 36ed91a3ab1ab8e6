// SPDX-License-Identifier: MIT
//
// The vocabulary of figures against what a sweep stores, and against its page in docs/; and which caches a
// sweep models.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

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

/// "heap.{structure}.slack_bytes" as what its stored names look like.
std::regex pattern_of(const std::string& name) {
    std::string pattern = std::regex_replace(name, std::regex(R"([.^$*+?()\[\]\\|])"), R"(\$&)");
    return std::regex(std::regex_replace(pattern, std::regex(R"(\{[a-z]+\})"), ".+"));
}

/// docs/generate rewrites the page.
TEST(Figures, AreDocumented) {
    const Folder folder;
    std::string rows;
    for (const json& figure : figures(folder)) {
        const auto text = [&](const char* key) { return figure.at(key).get<std::string>(); };
        rows += "| `" + text("name") + "` | " + text("unit") + " | " + text("population") + " | " +
                (figure.at("deterministic").get<bool>() ? "yes" : "no") + " | " + text("meaning") + " |\n";
    }
    EXPECT_THAT(text_of(figures_page), testing::EndsWith("|---|---|---|---|---|\n" + rows))
        << "run docs/generate";
}

TEST(Figures, OfASweepAreAllInTheVocabulary) {
    const Folder folder;
    const Outcome sweep =
        run(words_of("sweep --scenes tumble,static,cold --shapes cube8,sphere38 --layouts aos_f64 "
                     "--queries 200 --checked 20 --rounds 1 --caches sphere38 --stability 5 "
                     "--axes allocator=arena --store s.db"),
            folder);
    ASSERT_EQ(sweep.exit_code, 0) << sweep.err;
    std::vector<std::pair<std::regex, std::string>> known;
    for (const json& figure : figures(folder))
        known.emplace_back(pattern_of(figure.at("name")), figure.at("unit"));
    const auto stored = rows_of(folder / "s.db", "select distinct probe || '.' || name, unit from figure");
    EXPECT_GT(stored.size(), 250U);
    for (const std::string& row : stored) {
        const std::string name = row.substr(0, row.find('|')), unit = row.substr(row.find('|') + 1);
        const auto is_it = [&](const auto& entry) {
            return std::regex_match(name, entry.first) && unit.starts_with(entry.second);
        };
        EXPECT_TRUE(std::any_of(known.begin(), known.end(), is_it)) << row;
    }
}

TEST(Caches, AreModelledForCellsThatAskForIt) {
    const Folder folder;
    folder.write("mine.json", R"({"what": "mine", "clock_mhz": 1000, "line_bytes": 64,
        "levels": [{"name": "L1D", "bytes": 4096, "ways": 4, "latency_cycles": 4, "source": "me"}],
        "memory": {"latency_cycles": 100, "source": "me"}})");
    const Arguments arguments = {
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
}

/// A table that is built again takes another time.
TEST(Caches, AreNotModelledAgainForTheSameMachines) {
    const Folder folder;
    Arguments arguments = {"sweep",     "--scenes", "static",     "--shapes", "sphere38",
                           "--layouts", "aos_f64",  "--queries",  "200",      "--checked",
                           "20",        "--rounds", "1",          "--caches", "sphere38",
                           "--store",   "s.db",     "--machines", "zen5"};
    const auto built = [&] {
        EXPECT_EQ(run(arguments, folder).exit_code, 0);
        return rows_of(folder / "s.db", "select hash, value from figure where name = 'build_ns' order by 1");
    };
    const auto first = built();
    ASSERT_FALSE(first.empty());
    EXPECT_EQ(built(), first);
    arguments.back() = "zen4";
    EXPECT_NE(built(), first);
}

}  // namespace
}  // namespace edgewise::cli_test
