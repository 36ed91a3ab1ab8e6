// SPDX-License-Identifier: MIT
//
// The store: what goes in comes out, files of others stay as they are, and a killed process loses no
// committed round.
#include "edgewise/store/store.hpp"

#include <gmock/gmock.h>
#include <sqlite3.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <tuple>

#include "../complaint.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/schema.hpp"
#include "store_fixture.hpp"

namespace edgewise::store {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

using Rounds = std::vector<std::pair<std::string, measure::Round>>;

BuildRow sample_build(const std::string& id = "build-1") {
    return {id, "abc123", "g++ 12", "-O3 -ffp-contract=off", "Release", R"({"cpu":{"name":"x"}})"};
}

CellRow sample_cell(const std::string& hash = "cell-1") {
    return {hash,
            "tumble",
            R"({"rotation_step":0.01})",
            "sphere386",
            "built-in",
            "vclip",
            "aos",
            "f64",
            "aos_f64",
            386,
            1152,
            768,
            42,
            100'000,
            CellStatus::verified,
            "",
            "gap_tolerance=1e-06"};
}

void expect_equal(const CellRow& a, const CellRow& b) {
    const auto tied = [](const CellRow& c) {
        return std::tie(c.hash, c.scene, c.scene_parameters, c.shape, c.shape_source, c.algorithm, c.layout,
                        c.precision, c.table, c.vertices, c.edges, c.faces, c.seed, c.queries, c.status,
                        c.reason);
    };
    EXPECT_TRUE(tied(a) == tied(b)) << a.hash << " " << b.hash;
}

void expect_equal(const FigureRow& a, const FigureRow& b) {
    const auto tied = [](const FigureRow& f) {
        return std::tie(f.probe, f.name, f.value, f.unit, f.reason, f.remedy);
    };
    EXPECT_TRUE(tied(a) == tied(b)) << a.name << " " << b.name;
}

/// Opening must fail with one line that holds the path and `words`, and must leave every byte as it was.
void expect_refused(const std::string& path, const std::string& words) {
    const std::string before = bytes_of(path);
    EXPECT_THAT(complaint_of([&] { const Store store(path); }),
                AllOf(HasSubstr(path), HasSubstr(words), Not(HasSubstr("\n"))));
    EXPECT_EQ(bytes_of(path), before);
    EXPECT_FALSE(std::filesystem::exists(path + "-wal"));
}

TEST_F(StoreTest, EveryFieldComesBackAfterReopening) {
    CellRow cell = sample_cell();
    cell.seed = std::numeric_limits<std::uint64_t>::max() - 5;  // beyond what a signed number holds
    cell.status = CellStatus::failed;
    cell.reason = "query 17: wrong verdict, \"quoted\", and umlaut \xc3\xa4";
    const std::vector<FigureRow> figures = {
        {{"paper", 168.0, "B/edge", "", ""}, "bytes"},
        {{"tiny", 5e-324, "1", "", ""}, "bytes"},
        {{"misses", std::nullopt, "1", "no counters", "run on the bare machine"}, "counters"},
        {{"worst", 0.1, "1", "", ""}, "error"}};
    {
        Store store(path_);
        store.put_build(sample_build());
        store.put_cell("build-1", cell, figures);
        store.set_meta("plan", "quick");
        store.set_meta("plan", "paper");
    }
    const Store store(path_);
    const auto found = store.find_cell("build-1", "cell-1");
    ASSERT_TRUE(found);
    expect_equal(*found, cell);
    const auto& back = found->figures;
    ASSERT_EQ(back.size(), figures.size());
    for (std::size_t i = 0; i < back.size(); ++i) expect_equal(back[i], figures[i]);
    EXPECT_EQ(find_meta(path_, "plan"), "paper");
    EXPECT_EQ(find_meta(path_, "none"), std::nullopt);
}

TEST_F(StoreTest, TheBuildComesBackAndIsReplaced) {
    Store store(path_);
    BuildRow first = sample_build();
    first.compiler = "another";
    store.put_build(first);
    store.put_cell("build-1", sample_cell(), {});
    store.put_build(sample_build());  // although a cell refers to it
    const auto build = find_build(sqlite::Database(path_), "build-1");
    ASSERT_TRUE(build);
    EXPECT_EQ(build->git_revision, "abc123");
    EXPECT_EQ(build->compiler, "g++ 12");
    EXPECT_EQ(build->flags, "-O3 -ffp-contract=off");
    EXPECT_EQ(build->build_type, "Release");
    EXPECT_EQ(build->machine_json, R"({"cpu":{"name":"x"}})");
    EXPECT_TRUE(store.find_cell("build-1", "cell-1"));
}

TEST_F(StoreTest, ReplacesTheSameCellAndKeepsItsRounds) {
    Store store(path_);
    store.put_build(sample_build());
    store.put_cell("build-1", sample_cell(),
                   std::vector<FigureRow>{{{"x", 1.0, "1"}, "a"}, {{"y", 2.0, "1"}, "a"}});
    const Rounds round = {{"cell-1", sample_round(0)}};
    store.put_round("build-1", round);

    CellRow changed = sample_cell();
    changed.queries = 7;
    store.put_cell("build-1", changed, std::vector<FigureRow>{{{"y", 3.0, "1"}, "a"}});
    EXPECT_EQ(store.find_cell("build-1", "cell-1")->queries, 7u);
    const auto figures = store.find_cell("build-1", "cell-1")->figures;
    ASSERT_EQ(figures.size(), 1u);  // x is gone
    EXPECT_EQ(figures[0].value, 3.0);
    EXPECT_EQ(store.rounds_done("build-1", "cell-1"), std::set<int>{0});
}

/// Errors of fewer answers do not keep the rest of those of more.
TEST_F(StoreTest, CompletesFiguresButNotErrors) {
    Store store(path_);
    store.put_build(sample_build());
    store.put_cell("build-1", sample_cell(),
                   std::vector<FigureRow>{{{"checked", 2000.0, "1"}, "error"},
                                          {{"p999", 9.0, "1"}, "error"},
                                          {{"L1", 4.0, "1"}, "caches"},
                                          {{"x", 5.0, "1"}, "a"}});
    const auto completed = [&](std::vector<FigureRow> figures) {
        std::map<std::string, std::optional<double>> values;
        for (const FigureRow& figure : store.with_stored_figures("build-1", "cell-1", std::move(figures)))
            values[figure.probe + "." + figure.name] = figure.value;
        return values;
    };
    using Values = std::map<std::string, std::optional<double>>;
    EXPECT_EQ(completed({{{"checked", 200.0, "1"}, "error"},
                         {{"p999", std::nullopt, "1"}, "error"},
                         {{"x", std::nullopt, "1"}, "a"}}),
              (Values{{"error.checked", 200}, {"error.p999", {}}, {"a.x", 5}, {"caches.L1", 4}}));
    EXPECT_EQ(completed({{{"x", 6.0, "1"}, "a"}}),
              (Values{{"error.checked", 2000}, {"error.p999", 9}, {"a.x", 6}, {"caches.L1", 4}}));
}

TEST_F(StoreTest, KeepsBuildsApart) {
    Store store(path_);
    for (const char* id : {"build-1", "build-2"}) {
        store.put_build(sample_build(id));
        CellRow cell = sample_cell();
        cell.reason = id;
        store.put_cell(id, cell, std::vector<FigureRow>{{{"x", id[6] - '0' + 0.0, "1"}, "a"}});
    }
    const Rounds round = {{"cell-1", sample_round(3)}};
    store.put_round("build-2", round);
    EXPECT_EQ(store.find_cell("build-1", "cell-1")->reason, "build-1");
    EXPECT_EQ(store.find_cell("build-2", "cell-1")->reason, "build-2");
    EXPECT_EQ(store.find_cell("build-1", "cell-1")->figures[0].value, 1.0);
    EXPECT_EQ(store.find_cell("build-2", "cell-1")->figures[0].value, 2.0);
    EXPECT_TRUE(store.rounds_done("build-1", "cell-1").empty());
    EXPECT_EQ(store.rounds_done("build-2", "cell-1"), std::set<int>{3});
    EXPECT_FALSE(store.find_cell("build-3", "cell-1"));
    EXPECT_FALSE(find_build(sqlite::Database(path_), "build-3"));
}

TEST_F(StoreTest, RoundsComeBackInOrderAndReplaceEachOther) {
    Store store(path_);
    for (const int number : {2, 0, 5}) {
        const Rounds rounds = {{"cell-1", sample_round(number)}, {"cell-2", sample_round(number + 1)}};
        store.put_round("build-1", rounds);
    }
    measure::Round changed = sample_round(5);
    changed.baseline.overlapping_ns = 1e9;
    store.put_round("build-1", Rounds{{"cell-1", changed}});

    EXPECT_EQ(store.rounds_done("build-1", "cell-1"), (std::set<int>{0, 2, 5}));
    EXPECT_EQ(store.rounds_done("build-1", "cell-2"), (std::set<int>{1, 3, 6}));
    const auto rounds = store.rounds("build-1", "cell-1");
    ASSERT_EQ(rounds.size(), 3u);
    EXPECT_TRUE(equal(rounds[0], sample_round(0)));
    EXPECT_TRUE(equal(rounds[1], sample_round(2)));
    EXPECT_TRUE(equal(rounds[2], changed));
}

TEST_F(StoreTest, AFailingWriteChangesNothing) {
    Store store(path_);
    store.put_build(sample_build());
    store.put_cell("build-1", sample_cell(), std::vector<FigureRow>{{{"x", 1.0, "1"}, "a"}});

    measure::Round broken = sample_round(2);
    broken.timing.separated_ns =
        std::numeric_limits<double>::quiet_NaN();  // SQLite's null, which the column refuses
    const Rounds rounds = {{"cell-1", sample_round(2)}, {"cell-2", broken}};
    EXPECT_THROW(store.put_round("build-1", rounds), std::runtime_error);
    EXPECT_TRUE(store.rounds_done("build-1", "cell-1").empty());

    EXPECT_THROW(
        store.put_cell("build-1", sample_cell(), std::vector<FigureRow>{{{"z", std::nullopt, "1"}, "a"}}),
        std::runtime_error);  // neither value nor reason
    const auto figures = store.find_cell("build-1", "cell-1")->figures;
    ASSERT_EQ(figures.size(), 1u);
    EXPECT_EQ(figures[0].name, "x");

    EXPECT_THROW(store.put_cell("no such build", sample_cell(), {}), std::runtime_error);
    EXPECT_EQ(store.find_cell("build-1", "cell-1")->status, CellStatus::verified);
    store.put_cell("build-1", sample_cell("cell-9"), {});  // and goes on
    EXPECT_TRUE(store.find_cell("build-1", "cell-9"));
}

TEST_F(StoreTest, AValueThatIsNotFiniteIsNullWithAReason) {
    Store store(path_);
    store.put_build(sample_build());
    const double infinity = std::numeric_limits<double>::infinity();
    store.put_cell("build-1", sample_cell(),
                   std::vector<FigureRow>{{{"x", std::nan(""), "1"}, "a"}, {{"y", -infinity, "1"}, "a"}});
    const auto figures = store.find_cell("build-1", "cell-1")->figures;
    for (const FigureRow& row : figures) {
        EXPECT_FALSE(row.value);
        EXPECT_NE(row.reason.find("not a finite number"), std::string::npos) << row.reason;
    }
    EXPECT_EQ(figures.size(), 2u);
}

TEST_F(StoreTest, RefusesWhatIsNotItsOwn) {
    const auto file = [&](const char* name) { return (directory_ / name).string(); };
    std::ofstream(file("short.txt")) << "hello\n";
    expect_refused(file("short.txt"), "not an SQLite file");
    std::ofstream(file("long.txt")) << std::string(5000, 'x');
    expect_refused(file("long.txt"), "not an SQLite file");

    run_sql(file("foreign.db"), "create table songs(name text); insert into songs values('x')");
    expect_refused(file("foreign.db"), "not an Edgewise store");
    run_sql(file("versioned.db"), "create table songs(name text); pragma user_version = 1");
    expect_refused(file("versioned.db"), "not an Edgewise store");

    { const Store store(path_); }
    run_sql(path_, "pragma journal_mode = delete; pragma user_version = " +
                       std::to_string(store_schema_version + 1));
    expect_refused(path_, "newer program");
}

/// To SQLite, names that begin with a colon are databases in memory.
TEST_F(StoreTest, OfANameThatBeginsWithAColonIsAFile) {
    const TemporaryFolder folder;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    Store(":memory:").set_meta("seed", "7");
    EXPECT_TRUE(std::filesystem::is_regular_file("./:memory:"));
    EXPECT_NO_THROW(static_cast<void>(sqlite::Database::for_reading(":memory:")));
    EXPECT_EQ(Store(":memory:").meta("seed"), "7");
    std::filesystem::current_path(before);
}

TEST_F(StoreTest, RefusesPathsThatCannotBeAStore) {
    EXPECT_THROW(Store(""), std::runtime_error);
    EXPECT_THROW(Store(directory_.string()), std::runtime_error);
    const std::string missing = (directory_ / "missing" / "test.db").string();
    EXPECT_THAT(complaint_of([&] { const Store store(missing); }),
                AllOf(HasSubstr(missing), HasSubstr("directory")));
}

TEST_F(StoreTest, AnEmptyFileBecomesAStoreAndItsVersionIsInThePragma) {
    std::ofstream(path_).close();
    { Store(path_).set_meta("a", "b"); }
    EXPECT_EQ(find_meta(path_, "a"), "b");
    const std::string header = bytes_of(path_).substr(0, 72);
    ASSERT_EQ(header.size(), 72u);
    // sqlite.org/fileformat.html: big-endian, user_version at 60, application_id at 68.
    EXPECT_EQ(header[63], static_cast<char>(store_schema_version));
    EXPECT_EQ(header.substr(68, 4), "EdGe");
}

}  // namespace
}  // namespace edgewise::store
