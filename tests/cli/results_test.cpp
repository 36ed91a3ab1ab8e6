// SPDX-License-Identifier: MIT
//
// A sweep's files of results and `edgewise export`, compared with their store; the claims of two stores
// compared; and machine records.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "cli_paths.hpp"
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

/// The numbers in them are tested in tests/unit/reports/results_test.cpp.
void expect_every_cell_in_files(const Folder& folder) {
    std::size_t cells = 0, bytes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "results")) {
        if (entry.path().extension() != ".csv") continue;
        const std::string text = text_of(entry.path());
        bytes += text.size();
        if (entry.path().parent_path().filename() != "about") cells += CsvTable(text).rows();
    }
    EXPECT_EQ(cells, std::stoul(rows_of(folder / "s.db", "select count(*) from cell").at(0)));
    EXPECT_LT(bytes, 1500 * cells) << "what is said once included; 5 MB are 3300 cells";
}

void expect_every_figure_in_export(const Folder& folder) {
    const Outcome outcome = run({"export", "s.db", "--figures", "*", "--out", "all.csv"}, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const CsvTable all(text_of(folder / "all.csv"));
    std::size_t measured = 0;
    for (std::size_t row = 0; row < all.rows(); ++row) measured += all.text(row, "state") == "measured";
    EXPECT_EQ(measured, figures_in(folder / "s.db").size());
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

/// A store of cubes and one without their V-Clip differ in what is said of V-Clip's bytes.
void expect_compared_claims(const Folder& folder) {
    Arguments poorer = rich;
    poorer.back() = "t.db";
    ASSERT_EQ(run(with(poorer, {"--algorithms", "gjk"}), folder).exit_code, 0);

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
    EXPECT_EQ(run({"report", "claims", "s.db", "--diff", "missing.db"}, folder).exit_code, 2);
}

/// A store has changed in nothing since itself, and its report says so.
void expect_compared_report(const Folder& folder) {
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

/// One sweep for all that reads its store.
TEST(Results, HaveEveryCellAndFigureAndAreCompared) {
    const Folder folder;
    ASSERT_EQ(run(rich, folder).exit_code, 0);
    expect_every_cell_in_files(folder);
    expect_every_figure_in_export(folder);
    expect_compared_report(folder);
    expect_compared_claims(folder);
}

TEST(MachineRecords, ComeFromASweepAndAreCompared) {
    const Folder folder;
    const Outcome swept =
        run(words_of("sweep --layouts aos_f64,lean_f32 --algorithms vclip --scenes cold --shapes sphere386 "
                     "--queries 300 --rounds 4 --caches all --machines zen5 --store s.db --out pages"),
            folder);
    ASSERT_EQ(swept.exit_code, 0) << swept.err;
    const Outcome measured = run({"export", "s.db", "--machine-record", "--out", "mine.json"}, folder);
    ASSERT_EQ(measured.exit_code, 0) << measured.err;
    const Outcome modelled =
        run({"export", "s.db", "--machine-record", "--modelled", "zen5", "--out", "zen5.json"}, folder);
    ASSERT_EQ(modelled.exit_code, 0) << modelled.err;
    const Outcome compared = run({"compare", "mine.json", "zen5.json", "--json"}, folder);
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    const json result = json::parse(compared.out);
    EXPECT_EQ(result["machines"][1]["modelled"], true);
    ASSERT_EQ(result["questions"].size(), 1U);
    EXPECT_FALSE(result["questions"][0]["first"][1]["tables"].empty());
    EXPECT_EQ(run({"compare", "nothing.json"}, folder).exit_code, 2);
}

TEST(MachineRecords, ThreeModelsAreThereToBeCompared) {
    const Folder folder;
    Arguments arguments = {"compare", "--json"};
    for (const auto& entry : std::filesystem::directory_iterator(records_folder))
        arguments.push_back(entry.path().string());
    const Outcome compared = run(arguments, folder);
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    const json result = json::parse(compared.out);
    ASSERT_EQ(result["machines"].size(), 3U);
    for (const json& machine : result["machines"]) EXPECT_EQ(machine["modelled"], true);
    EXPECT_GT(result["questions"].size(), 3U);
    const std::string zen3 = text_of(records_folder + std::string("/zen3.json"));
    json other = json::parse(zen3);
    ASSERT_FALSE(other["cells"].empty());
    folder.write("zen3.json", zen3);
    json elsewhere;
    for (const auto& [cell, figures] : other["cells"].items())
        elsewhere["elsewhere" + cell.substr(cell.find(' '))] = figures;
    other["cells"] = elsewhere;
    folder.write("other.json", other.dump());
    EXPECT_EQ(run({"compare", "zen3.json", "zen3.json"}, folder).exit_code, 0);
    const Outcome nothing = run({"compare", "zen3.json", "other.json"}, folder);
    EXPECT_EQ(nothing.exit_code, 1);
    EXPECT_THAT(nothing.err, HasSubstr("nothing was compared"));
    arguments[1] = records_folder + std::string("/zen3.json");
    EXPECT_THAT(run(arguments, folder).out, HasSubstr("zen3 (model)"));
}

TEST(Bytes, ShowsTheWaysTo168) {
    const Folder folder;
    const Outcome bytes = run({"bytes", "--layouts", "aos_f64", "--shape", "cube8", "--json"}, folder);
    ASSERT_EQ(bytes.exit_code, 0) << bytes.err;
    const json ledger = json::parse(bytes.out);
    int reach = 0, halve = 0;
    for (const json& way : ledger["decompositions"]) {
        reach += way["f64"] == 168;
        halve += way["f64"] == 168 && way["f32"] == 84;
    }
    EXPECT_GE(reach, 6);
    EXPECT_GE(halve, 3);
    EXPECT_LT(halve, reach);
}

}  // namespace
}  // namespace edgewise::cli_test
