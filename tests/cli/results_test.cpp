// SPDX-License-Identifier: MIT
//
// A sweep's files of results and `edgewise export`, compared number by number with their store; and the
// claims of two stores compared.
#include <gmock/gmock.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "csv_reader.hpp"
#include "program.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using reports::CsvTable;
using testing::HasSubstr;
using testing::Not;

/// Modelled caches, stability rows: the cells with the most figures.
const Arguments rich = {
    "sweep",     "--scenes", "tumble,cold",         "--shapes",    "cube8",    "--layouts", "aos_f64",
    "--queries", "200",      "--checked",           "20",          "--rounds", "1",         "--caches",
    "all",       "--axes",   "gap_tolerance=0.001", "--stability", "2",        "--store",   "s.db"};

TEST(Results, AreTheStoresNumbersInFewBytesPerCell) {
    const Folder folder;
    ASSERT_EQ(run(rich, folder).exit_code, 0);
    const auto stored = figures_in(folder / "s.db");
    std::size_t cells = 0, numbers = 0, bytes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "results")) {
        if (entry.path().extension() != ".csv") continue;
        const std::string text = text_of(entry.path());
        bytes += text.size();
        if (entry.path().parent_path().filename() == "about") continue;
        const CsvTable table(text);
        cells += table.rows();
        for (std::size_t row = 0; row < table.rows(); ++row)
            for (const std::string& column : table.columns()) {
                if (column.find('.') == std::string::npos || table.raw(row, column).empty()) continue;
                const auto found = stored.find(table.text(row, "hash") + " " + column);
                ASSERT_NE(found, stored.end()) << column;
                EXPECT_EQ(std::strtod(table.raw(row, column).c_str(), nullptr), found->second) << column;
                ++numbers;
            }
    }
    EXPECT_EQ(cells, std::stoul(rows_of(folder / "s.db", "select count(*) from cell").at(0)));
    EXPECT_GT(numbers, 30 * cells);
    EXPECT_LT(bytes, 1500 * cells) << "what is said once included; 5 MB are 3300 cells";
}

TEST(Export, WritesBreakdownsWhereItIsTold) {
    const Folder folder;
    ASSERT_EQ(run(rich, folder).exit_code, 0);
    const auto stored = figures_in(folder / "s.db");
    const Outcome outcome = run({"export", "s.db", "--figures", "*", "--out", "all.csv"}, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const CsvTable all(text_of(folder / "all.csv"));
    std::size_t measured = 0;
    for (std::size_t row = 0; row < all.rows(); ++row) {
        if (all.text(row, "state") != "measured") continue;
        const std::string key =
            all.text(row, "hash") + " " + all.text(row, "probe") + "." + all.text(row, "figure");
        ASSERT_TRUE(stored.contains(key)) << key;
        EXPECT_EQ(std::strtod(all.raw(row, "value").c_str(), nullptr), stored.at(key)) << key;
        ++measured;
    }
    EXPECT_EQ(measured, stored.size());

    const Outcome some = run(
        {"export", "s.db", "--scenes", "cold", "--figures", "caches.*.step.*", "--format", "json"}, folder);
    ASSERT_EQ(some.exit_code, 0) << some.err;
    const json cells = json::parse(some.out).at("cells");
    ASSERT_FALSE(cells.empty());
    for (const json& cell : cells) {
        EXPECT_EQ(cell["scene"], "cold");
        for (const json& figure : cell["figures"])
            EXPECT_THAT(figure["figure"].get<std::string>(), HasSubstr(".step."));
    }
}

TEST(Export, OfWhatTheStoreLacksIsOneLine) {
    const Folder folder;
    ASSERT_EQ(run(rich, folder).exit_code, 0);
    const std::map<std::string, Arguments> slips = {
        {"unknown scene of the store 'nope'", {"--scenes", "nope"}},
        {"'nope_f64'", {"--layouts", "nope_f64"}},
        {"matches 'nope'", {"--figures", "nope"}}};
    for (const auto& [words, more] : slips) {
        Arguments arguments = {"export", "s.db"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = run(arguments, folder);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(words));
    }
}

/// A store of cubes and one without their V-Clip differ in what is said of V-Clip's bytes.
TEST(Claims, AreComparedBetweenStores) {
    const Folder folder;
    ASSERT_EQ(run(rich, folder).exit_code, 0);
    Arguments poorer = rich;
    poorer.back() = "t.db";
    poorer.insert(poorer.end(), {"--algorithms", "gjk"});
    ASSERT_EQ(run(poorer, folder).exit_code, 0);

    const Outcome same = run({"report", "claims", "s.db", "--diff", "s.db"}, folder);
    EXPECT_EQ(same.exit_code, 0) << same.err;
    EXPECT_THAT(same.out, HasSubstr("s.db: passed; "));
    const Outcome differs = run({"report", "claims", "s.db", "--diff", "t.db", "--json"}, folder);
    EXPECT_EQ(differs.exit_code, 1) << differs.err;
    const json found = json::parse(differs.out);
    const auto verdicts = [&](const char* store) {
        std::map<std::string, std::string> all;
        const json judged = json::parse(run({"report", "claims", store, "--json"}, folder).out);
        for (const json& claim : judged.at("claims")) all[claim["id"]] = claim["verdict"];
        return all;
    };
    const auto first = verdicts("s.db"), second = verdicts("t.db");
    std::size_t expected = 0;
    for (const auto& [id, verdict] : first) expected += verdict != second.at(id);
    EXPECT_EQ(found["changed"], expected);
    EXPECT_EQ(found["rows"].size(), expected);
    EXPECT_EQ(found["compared"], first.size());
    for (const json& row : found["rows"]) {
        EXPECT_EQ(row["was"], first.at(row["cell"]));
        EXPECT_EQ(row["is"], second.at(row["cell"]));
    }
    const Outcome bad = run({"report", "claims", "s.db", "--diff", "missing.db"}, folder);
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_EQ(bad.out, "");
    EXPECT_EQ(lines_of(bad.err).size(), 1u) << bad.err;
    EXPECT_THAT(bad.err, HasSubstr("missing.db"));
}

/// A store has changed in nothing since itself, and its report says so.
TEST(ReportCompare, PrintsAndWritesWhatChanged) {
    const Folder folder;
    ASSERT_EQ(run(rich, folder).exit_code, 0);
    EXPECT_THAT(text_of(folder / "index.html"), Not(HasSubstr("id=\"changes\"")));
    const Outcome same = run({"report", "s.db", "--compare", "s.db", "--gate"}, folder);
    ASSERT_EQ(same.exit_code, 0) << same.out << same.err;
    EXPECT_THAT(same.out, HasSubstr("s.db: passed; "));
    EXPECT_EQ(lines_of(same.out).back(), "report: ./index.html");
    EXPECT_THAT(text_of(folder / "index.html"), HasSubstr("What changed since s.db?"));
    const Outcome elsewhere = run({"report", "s.db", "--compare", "s.db", "--out", "o", "--json"}, folder);
    ASSERT_EQ(elsewhere.exit_code, 0) << elsewhere.err;
    EXPECT_EQ(json::parse(elsewhere.out)["worse"], 0);
    EXPECT_THAT(text_of(folder / "o/report.md"), HasSubstr("## What changed since s.db?"));
    EXPECT_EQ(run({"report", "s.db", "--compare", "missing.db"}, folder).exit_code, 2);
    const Outcome stores = run({"compare", "s.db", "s.db"}, folder);
    EXPECT_EQ(stores.exit_code, 0) << stores.err;
    EXPECT_THAT(stores.out, HasSubstr("s.db: passed; "));
    EXPECT_EQ(run({"compare", "s.db", "missing.db"}, folder).exit_code, 2);
}

}  // namespace
}  // namespace edgewise::cli_test
