// SPDX-License-Identifier: MIT
//
// Further axes: read, written back the same, and refused with what is known.
//
// If memory for the tables runs out, the cell is unavailable, with that reason: it did not fail its check.
//
// Scene files that would go by one name are refused before anything is measured, both named.
#include "edgewise/sweep/axes.hpp"

#include <gmock/gmock.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "../complaint.hpp"
#include "../temporary_folder.hpp"
#include "edgewise/input/guarded.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/sweep/prepared_cell.hpp"
#include "edgewise/sweep/study.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string error_of(const char* text) {
    return complaint_of<std::invalid_argument>([&] { return parse_axes(text); });
}

TEST(Axes, ReadBackAsTheyAreWritten) {
    std::istringstream written(
        "contact_tolerance=0.001 gap_tolerance=1e-06 contact_tolerance=1e+20+gap_tolerance=0.01 order=bfs "
        "order=spatial order=rcm sharing=per_instance+batch=yes needs=distance+radius=0.02 sharing=shared "
        "allocator=jemalloc batch=yes start=cold build=default sub_distance=johnson hardening=off "
        "needs=certificate needs=nearer+margin=0.1 needs=nearer+margin=0.02 needs=within+margin=0.1 "
        "radius=recorded start=cold+needs=verdict+radius=2 start=cold+build=default "
        "gap_tolerance=0.5+order=bfs+sharing=shared+allocator=libc");
    for (std::string text; written >> text;) EXPECT_EQ(parse_axes(text).text(), text);
    EXPECT_EQ(parse_axes("gap_tolerance=0.010+contact_tolerance=1").text(),
              "contact_tolerance=1+gap_tolerance=0.01");
    for (const char* usual : {"", "gap_tolerance=0", "order=given+allocator=arena", "needs=witnesses",
                              "sub_distance=cofactors", "hardening=on", "radius=0"})
        EXPECT_EQ(parse_axes(usual).text(), "") << usual;
    EXPECT_EQ(parse_axes("sub_distance=johnson").query.sub_distance, SubDistanceSolver::johnson);
    EXPECT_EQ(parse_axes("needs=verdict").query.cutoff, 0);
    EXPECT_FALSE(parse_axes("needs=depth").query.is_for_verdict());
    EXPECT_EQ(parse_axes("needs=nearer").text(), "needs=nearer+margin=0.1") << "a condition of its figures";
    EXPECT_EQ(parse_axes("margin=2+needs=nearer").margin, 2);
    EXPECT_FALSE(parse_axes("needs=nearer").query.is_for_verdict()) << "bounds come from whole distances";
}

TEST(Axes, ConcernOnlyWhatTheyChange) {
    EXPECT_FALSE(Axes{}.concerns("gjk"));
    for (const char* of_both : {"contact_tolerance=0.1", "order=bfs", "batch=yes", "start=cold",
                                "build=default", "allocator=libc", "radius=1", "radius=recorded"})
        EXPECT_TRUE(parse_axes(of_both).concerns("vclip") && parse_axes(of_both).concerns("gjk")) << of_both;
    for (const char* of_gjk : {"gap_tolerance=0.1", "sub_distance=johnson"})
        EXPECT_TRUE(parse_axes(of_gjk).concerns("gjk") && !parse_axes(of_gjk).concerns("vclip")) << of_gjk;
    EXPECT_TRUE(parse_axes("hardening=off").concerns("vclip"));
    EXPECT_FALSE(parse_axes("hardening=off").concerns("gjk"));
}

TEST(Axes, BadOnesAreOneClearLine) {
    for (const char* text : {"gap_tolerance", "gap_tolerance=", "gap_tolerance=1", "gap_tolerance=-0.1",
                             "gap_tolerance=nan", "gap_tolerance=0.1x", "contact_tolerance=inf"}) {
        EXPECT_THAT(error_of(text), HasSubstr("wants a number from 0")) << text;
    }
    const std::pair<const char*, const char*> bad[] = {
        {"order=random", "wants given|bfs|spatial|rcm"},
        {"sharing", "wants shared|per_instance"},
        {"allocator=mine", "wants arena|jemalloc|libc"},
        {"hardening=maybe", "on|off"},
        {"margin=0.1", "write both"},
        {"needs=nearer+batch=yes", "leave batch out"},
        {"needs=within+batch=yes", "needs=within asks one pair"},
        {"batch=maybe", "no|yes"},
        {"start=warm", "kept|cold"},
        {"build=fast", "tool|default"},
        {"build=default+batch=yes", "leave batch=yes out"},
        {"sub_distance=volumes", "wants cofactors|johnson"},
        {"needs=verdict+margin=0.1", "write both"},
        {"needs=nearer+margin=0", "above 0"},
        {"needs=nearer+margin=x", "wants a number"},
        {"needs=nearer+contact_tolerance=1", "leave contact_tolerance out"},
        {"radius=-1", "wants a number"},
        {"needs=nearer+margin=0.1+margin=0.2", "given twice"},
        {"needs=verdict+", "missing after the plus"},
        {"radius=recorded+needs=within", "needs=verdict, distance"},
        {"radius=1+needs=depth", "needs=verdict, distance"},
        {"radius=1+batch=yes", "leave batch out"},
        {"radius=1+contact_tolerance=1", "leave contact_tolerance out"},
        {"speed=3", "unknown; known: "}};
    for (const auto& [text, says] : bad) EXPECT_THAT(error_of(text), HasSubstr(says)) << text;
}

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

std::string complaint(const std::vector<std::string>& scenes) {
    Plan plan;
    for (const std::string& name : scenes) plan.scenes.push_back({name});
    return complaint_of<std::invalid_argument>([&] { check_scene_names(plan); });
}

TEST(SceneNames, ThatMeetAreRefusedNamingBoth) {
    EXPECT_THAT(complaint({"c1/s.json", "c2/s.json"}),
                AllOf(HasSubstr("c1/s.json and c2/s.json"), HasSubstr("'s'")));
    EXPECT_THAT(complaint({"my scene.json", "cold", "my_scene.json"}),
                AllOf(HasSubstr("my scene.json and my_scene.json"), HasSubstr("'my_scene'")));
    EXPECT_EQ(complaint({"a.json", "b.json", "tumble", "tumble", "cold"}), "");
}

TEST(SceneNames, OfWhatComesAlongAreTaken) {
    for (const scene::SceneInfo& kind : scene::list_scenes())
        EXPECT_THAT(complaint({"mine/" + kind.name + ".json"}),
                    HasSubstr("kind of scene '" + kind.name + "'"));
    for (const scene::SceneText& text : scene::scene_texts()) {
        const std::string name(text.name);
        EXPECT_THAT(complaint({name + ".json"}), HasSubstr("'" + name + "' that comes along"));
        EXPECT_EQ(complaint({name}), "");
    }
}

/// A scene file may be called like a study, or begin like a scene that comes along: its rows say what
/// measured them.
TEST(SceneNames, OfStudiesAndBeginningsAreFree) {
    std::vector<std::string> runs = {store::sweep_run, "thrash_realised"};
    for (const Study& study : registered_studies()) runs.emplace_back(study.name);
    for (const std::string& run : runs)
        for (const std::string end : {"", "2", "ing", " tumble", "_mine"})
            EXPECT_EQ(complaint({run + end + ".json"}), "") << run << end;
    for (const scene::SceneInfo& kind : scene::list_scenes()) {
        EXPECT_EQ(complaint({kind.name + "2.json"}), "");
        EXPECT_EQ(complaint({kind.name.substr(0, kind.name.size() - 1) + ".json"}), "");
    }
    EXPECT_EQ(complaint({"paper_mine.json", "paper_bodies_of_mine.json"}), "");
}

/// If two runs into one store use different files for a scene, the error names both files.
TEST(SceneNames, OfFilesThatDifferDoNotShareAStore) {
    const TemporaryFolder folder;
    store::Store store(folder / "s.db");
    SweepWork work;
    work.scenes.emplace_back();
    SceneWork& scene = work.scenes.back();
    scene.choice.name = "s", scene.json = R"({"scene":"tumble"})", scene.path = "c1/s.json";
    EXPECT_NO_THROW(check_scene_files(work, store));
    store.set_meta(store::scene_file_key + scene.choice.name, scene.json);
    store.set_meta(store::scene_path_key + scene.choice.name, scene.path);
    EXPECT_NO_THROW(check_scene_files(work, store)) << "the same again";
    scene.json = R"({"scene":"cold"})", scene.path = "c2/s.json";
    EXPECT_THAT(complaint_of<std::invalid_argument>([&] { check_scene_files(work, store); }),
                AllOf(HasSubstr("c1/s.json"), HasSubstr("c2/s.json"), HasSubstr("rename")));
}

/// A file that is named twice is one scene, for example for other layouts.
TEST(SceneNames, OfOneFileDoNotMeet) {
    const TemporaryFolder folder;
    const std::string path = folder.write("s.json", "{}"), again = folder / "./s.json";
    EXPECT_EQ(complaint({path, again, path}), "");
    EXPECT_EQ(complaint({"beside_the_builds.jsonl.gz", "beside_the_builds.jsonl.gz"}), "");
}

}  // namespace
}  // namespace edgewise::sweep
