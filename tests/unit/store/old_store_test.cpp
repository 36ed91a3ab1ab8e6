// SPDX-License-Identifier: MIT
//
// Stores of the previous schema and read-only files can be read, and reading leaves no files
// behind.
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "edgewise/store/merge.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/schema.hpp"
#include "store_fixture.hpp"

namespace edgewise::store {
namespace {

using testing::UnorderedElementsAre;

/// Name of a scene in schema version 5, and the scene and run that it has now.
struct OldRow {
    const char *old_scene, *scene, *run;
};
constexpr OldRow old_rows[] = {
    {"stability", "stability", "stability"}, {"paging", "paging", "paging"},
    {"thrash", "thrash", "thrash"},          {"thrash_realised", "thrash_realised", "thrash_realised"},
    {"effort tumble", "tumble", "effort"},   {"fields tumble", "tumble", "fields"},
    {"tumble", "tumble", "sweep"},           {"thrashing", "thrashing", "sweep"},
    {"effortless", "effortless", "sweep"},   {"Effort tumble", "Effort tumble", "sweep"},
    {"stability2", "stability2", "sweep"},   {"cold_start", "cold_start", "sweep"}};

constexpr const char* to_version_5 = R"(pragma foreign_keys = off; alter table cell rename to new_cell;
    create table cell(
    build text not null references build(id), hash text not null,
    scene text not null, scene_parameters text not null,
    shape text not null, shape_source text not null,
    algorithm text not null, layout text not null, precision text not null, table_type text not null,
    vertices integer not null, edges integer not null, faces integer not null,
    seed integer not null, queries integer not null,
    status text not null check(status in ('verified', 'failed', 'unavailable', 'judged')), reason text not null,
    axes text not null, primary key(build, hash)) without rowid;
    insert into cell select build, hash, scene, scene_parameters, shape, shape_source, algorithm, layout,
        precision, table_type, vertices, edges, faces, seed, queries, status, reason, axes from new_cell;
    drop table new_cell; pragma user_version = 5;)";

class OldStore : public StoreTest {
  protected:
    void SetUp() override {
        make(path_);
        run_sql(path_, to_version_5);
    }
    static void make(const std::string& path) {
        Store store(path);
        store.put_build({"b", "abc", "g++", "-O3", "Release", "{}"});
        store.set_meta("build", "b");
        for (const OldRow& row : old_rows) {
            CellRow cell;
            cell.hash = cell.scene = row.old_scene;
            cell.status = CellStatus::verified;
            const FigureRow figure[] = {{{"all_ns", 5.0, "ns"}, "time"}};
            store.put_cell("b", cell, figure);
        }
    }
    static void expect_runs(const std::string& path) {
        std::map<std::string, StoredCell> cells;
        for (const StoredCell& cell : read_build(path).cells) cells.emplace(cell.hash, cell);
        EXPECT_EQ(cells.size(), std::size(old_rows));
        for (const OldRow& row : old_rows) {
            const StoredCell& cell = cells.at(row.old_scene);
            EXPECT_EQ(cell.scene, row.scene);
            EXPECT_EQ(cell.run, row.run) << row.old_scene;
            EXPECT_EQ(cell.figure("time.all_ns").value, 5.0);
        }
    }
    [[nodiscard]] std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(directory_))
            names.push_back(entry.path().filename().string());
        return names;
    }
};

TEST_F(OldStore, IsReadAsItWouldBeWrittenToday) {
    const std::string before = bytes_of(path_);
    expect_runs(path_);
    EXPECT_EQ(bytes_of(path_), before) << "reading changes nothing";
}

TEST_F(OldStore, IsMergedIntoOneOfToday) {
    const std::string out = (directory_ / "all.db").string();
    EXPECT_EQ(merge_stores({path_}, out, false).cells, std::size(old_rows));
    expect_runs(out);
    const auto merged = sqlite::Database::for_reading(out);
    EXPECT_EQ(merged.number("pragma user_version"), store_schema_version);
    EXPECT_EQ(merged.number("select count(*) from cell where run <> 'sweep'"), 6);
}

TEST_F(OldStore, BecomesOneOfTodayWhenItIsWritten) {
    for (int again = 0; again < 2; ++again) {
        Store store(path_);
        EXPECT_EQ(store.find_cell("b", "effort tumble")->run, "effort");
        CellRow mine;
        mine.hash = mine.scene = "effort mine";
        mine.status = CellStatus::judged;
        store.put_cell("b", mine, {});
        EXPECT_EQ(store.find_cell("b", mine.hash)->scene, "effort mine")
            << "a scene of today is never taken apart";
        EXPECT_EQ(store.find_cell("b", mine.hash)->run, "sweep");
    }
    run_sql(path_, "delete from cell where hash = 'effort mine'");
    expect_runs(path_);
}

/// Another program may have added some: they are not copied, and no hindrance.
TEST_F(OldStore, FurtherColumnsAreNoHindrance) {
    run_sql(path_,
            "alter table cell add column remark text; alter table figure add column remark text;"
            "alter table round add column remark text; alter table build add column remark text");
    expect_runs(path_);
    const std::string out = (directory_ / "all.db").string();
    EXPECT_EQ(merge_stores({path_}, out, false).cells, std::size(old_rows));
    expect_runs(out);
    Store store(path_);
    CellRow one;
    one.hash = "one";
    EXPECT_NO_THROW(store.put_cell("b", one, {}));
}

TEST_F(OldStore, ReadersLeaveNothingBeside) {
    for (const bool log : {false, true}) {
        if (log) run_sql(path_, "pragma journal_mode = wal");
        expect_runs(path_);
        EXPECT_THAT(files(), UnorderedElementsAre("test.db")) << log;
    }
    Store writer(path_);  // a sweep at work
    writer.set_meta("a", "b");
    const std::vector<std::string> before = files();
    EXPECT_EQ(before.size(), 3U);
    expect_runs(path_);
    EXPECT_EQ(files().size(), before.size()) << "its log stays";
    EXPECT_EQ(find_meta(path_, "a"), "b") << "and is read";
}

/// The owner of the tests may write anywhere if it is root: a child without its rights reads.
TEST_F(OldStore, IsReadWhereNothingMayBeWritten) {
    run_sql(path_, "pragma journal_mode = wal");
    for (const bool folder : {true, false}) {
        ASSERT_EQ(chmod(path_.c_str(), folder ? 0644 : 0444), 0);
        ASSERT_EQ(chmod(directory_.c_str(), folder ? 0555 : 0755), 0);
        EXPECT_EXIT(
            {
                if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) std::exit(2);
                try {
                    std::exit(read_build(path_).cells.size() == std::size(old_rows) ? 0 : 1);
                } catch (const std::exception& problem) {
                    std::fprintf(stderr, "%s\n", problem.what());
                    std::exit(3);
                }
            },
            testing::ExitedWithCode(0), "");
        ASSERT_EQ(chmod(directory_.c_str(), 0755), 0);
        EXPECT_THAT(files(), UnorderedElementsAre("test.db"));
    }
}

}  // namespace
}  // namespace edgewise::store
