// SPDX-License-Identifier: MIT
//
// Plans: the named ones are what they are said to be, and can be run; a file overrides what it names; a bad
// one is one clear line.
#include "edgewise/sweep/plan.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "../complaint.hpp"
#include "../temporary_folder.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::UnorderedElementsAre;

class PlanFile : public ::testing::Test {
  protected:
    [[nodiscard]] std::string write(const std::string& text) const {
        return folder_.write("mine.json", text);
    }

    [[nodiscard]] static std::string error_of(const std::string& name) {
        return complaint_of<std::invalid_argument>([&] { return make_plan(name); });
    }

    const TemporaryFolder folder_;
};

std::size_t cells(const Plan& plan) {
    std::size_t served = 0;
    const auto chosen = bench::select_algorithms(plan.algorithms);
    for (const bench::TableType* type : bench::select_table_types(plan.layouts)) {
        for (const std::string& algorithm : type->algorithms) {
            served += static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), algorithm));
        }
    }
    return plan.scenes.size() * (plan.shapes.size() + plan.meshes.size()) * served;
}

TEST(Plan, EveryNamedPlanAsksForWhatThereIs) {
    for (const std::string& name : plan_names()) {
        const Plan plan = make_plan(name);
        EXPECT_EQ(plan.name, name);
        EXPECT_FALSE(bench::select_table_types(plan.layouts).empty());
        EXPECT_FALSE(bench::select_algorithms(plan.algorithms).empty());
        for (const SceneChoice& scene : plan.scenes) {
            if (const auto file = scene::find_scene_file(scene.name)) {
                const bool is_made_later = scene::names_recording(scene.name);  // by layouts/sweep
                EXPECT_TRUE(*file || is_made_later) << name << ": " << file->error;
                continue;
            }
            const auto complete = scene::complete_parameters(scene.name, scene.parameters);
            EXPECT_TRUE(complete) << name << ": " << complete.error;
        }
        for (const std::string& shape : plan.shapes) {
            const auto body = scene::make_shape(shape);
            EXPECT_TRUE(body) << name << ": " << body.error;
        }
        EXPECT_GE(plan.meshes.size(), 3U) << "real objects are part of every plan";
        EXPECT_LE(plan.checked, plan.queries);
        EXPECT_GE(plan.rounds, 6) << "fewer give no interval";
    }
}

TEST(Plan, QuickAndPaperKeepTheirPromises) {
    const Plan quick = make_plan("quick"), paper = make_plan("paper");
    EXPECT_GE(cells(quick), 100U);
    EXPECT_GE(quick.checked, 200U);
    EXPECT_EQ(quick.count_of("effort"), 0U) << "it needs valgrind and a second program";
    EXPECT_GT(make_plan("peers").count_of("effort"), 0U);
    EXPECT_GE(paper.checked, 2000U);
    EXPECT_EQ(paper.queries, 30000U);
}

using Names = std::vector<std::string>;

/// The layouts and table types that this program has.
Names built(Names layouts) {
    std::erase_if(layouts, [](const std::string& name) {
        const auto types = bench::table_types();
        return std::none_of(types.begin(), types.end(), [&](const bench::TableType& type) {
            return type.name == name || type.layout == name;
        });
    });
    return layouts;
}

/// "gap gap=0.001 span=0": a scene and the parameters that the plan sets.
Names conditions_of(const Plan& plan) {
    Names conditions;
    for (const SceneChoice& scene : plan.scenes) {
        conditions.push_back(scene.name);
        for (const auto& [name, value] : scene.parameters)
            conditions.back() += fmt::format(" {}={:g}", name, value);
    }
    return conditions;
}

const char* const near_contact[] = {"gap gap=0.001 span=0", "gap gap=0.0001 span=0",
                                    "proximity gap=0.001 pairs=100 rotation_step=0.0001",
                                    "proximity gap=0.0001 pairs=100 rotation_step=1e-05"};

/// The contest behind the report's answer: every body in every condition, and in each scene every contender.
TEST(Plan, QuickAsksEveryContenderInEveryConditionOfTheContest) {
    const Plan plan = make_plan("quick");
    Names wanted = {"cold", "tumble in_time_order=1 rotation_step=0.01",
                    "tumble in_time_order=1 rotation_step=0.1"};
    wanted.insert(wanted.end(), std::begin(near_contact), std::end(near_contact));
    wanted.insert(wanted.end(), {"pressure bodies=200", "pressure bodies=6000", "resting",
                                 "resting bodies=200 own_tables=1", "bullet_wall.jsonl.gz"});
    EXPECT_EQ(conditions_of(plan), wanted);
    const SweepWork work = prepare_sweep(plan, [](const std::string&) {});
    for (const SceneWork& scene : work.scenes) {
        Names bodies;
        for (const scene::NamedShape* shape : scene.shapes) bodies.push_back(shape->name);
        if (scene.json.empty()) {  // else a recording, of its own bodies
            EXPECT_THAT(bodies, UnorderedElementsAre("box8", "sphere38", "hubo_foot", "sphere386"));
        }
        std::set<std::pair<std::string, std::string>> cells;
        work.each_cell(scene, [&](const bench::TableType& type, const std::string& algorithm, const Axes&) {
            cells.emplace(algorithm, type.name);
        });
        for (const char* precision : {"_f64", "_f32"}) {
            for (const char* layout : {"aos", "lean", "lean_seeds"})
                for (const std::string& table : built({layout + std::string(precision)}))
                    EXPECT_TRUE(cells.contains({"vclip", table})) << scene.choice.name << " " << table;
            for (const char* layout : {"points_soa", "lean", "lean_seeds"})
                for (const std::string& table : built({layout + std::string(precision)}))
                    EXPECT_TRUE(cells.contains({"gjk", table})) << scene.choice.name << " " << table;
        }
    }
}

TEST(Plan, PeersAreAskedNearContactAndOnBoxesWithUnequalSides) {
    const Plan peers = make_plan("peers");
    EXPECT_THAT(conditions_of(peers), IsSupersetOf(near_contact));
    EXPECT_THAT(peers.shapes, IsSupersetOf({"cube8", "box8", "sphere38", "ellipsoid38"}));
}

struct PaperScene {
    const char* name;
    Names layouts, axes;
};

std::vector<PaperScene> paper_scenes() {
    const Names both = {"aos_f64", "lean_f64"};
    const Names timed = {"aos_f64", "aos_f32", "lean_f64", "points_neighbours_f64"};
    const Names in_static = {"aos_f64", "aos_f32", "linked_f64", "lean_f64", "points_neighbours_f64"};
    const Names thrashed = {"aos_f64", "linked_f64", "lean_f64"};
    const Names shared = {"sharing=shared"}, solved = {"sub_distance=johnson"}, cold = {"start=cold"},
                raw = {"hardening=off"}, assumed = {"sharing=shared", "needs=verdict"};
    const Names plain_only = {"aos_f64"}, tolerant = {"contact_tolerance=1e-05"};
    const Names asked = {
        "needs=nearer+margin=0.01", "needs=nearer",   "needs=nearer+margin=1", "needs=verdict",
        "needs=distance",           "needs=features", "needs=depth",           "needs=certificate"};
    return {{"paper_static", in_static, raw},
            {"paper_linear_8", both, solved},
            {"paper_bodies", both, {}},
            {"paper_bodies_shrinking", plain_only, {}},
            {"paper_angular_8", timed, shared},
            {"paper_angular_38", timed, shared},
            {"paper_angular_386", timed, shared},
            {"paper_proximity", timed, {}},
            {"paper_complexity", both, {}},
            {"paper_cold", both, solved},
            {"paper_needs", both, asked},
            {"paper_caches_here", both, {}},
            {"paper_thrash_8", thrashed, shared},
            {"paper_thrash_38", thrashed, shared},
            {"paper_thrash_386", thrashed, shared},
            {"paper_caching", both, cold},
            {"paper_seeds", plain_only, raw},
            {"paper_time_step", plain_only, assumed},
            {"paper_body_count", plain_only, {}},
            {"paper_margin", plain_only, {}},
            {"paper_static_margin", plain_only, {}},
            {"paper_static_gap", plain_only, {}},
            {"paper_tolerance", plain_only, tolerant},
            {"tumble", {}, {}},
            {"cold", {}, {}}};
}

void expect_scene(const SceneChoice& scene, const PaperScene& wanted) {
    const auto& [name, layouts, axes] = wanted;
    const bool own = std::string(name).starts_with("paper_"),
               traced = std::string(name).starts_with("paper_thrash_");
    EXPECT_EQ(scene.name, name);
    EXPECT_TRUE(scene.parameters.empty() && scene.algorithms.empty()) << name;
    EXPECT_EQ(scene.layouts, built(layouts)) << name;
    EXPECT_EQ(scene.axes, axes) << name;
    EXPECT_EQ(scene.plain, own && axes.empty()) << name;
    EXPECT_EQ(scene.caches, traced ? Names{"all"} : Names{}) << name;
    EXPECT_EQ(scene.queries, own ? 0U : 3000U) << name;
    EXPECT_EQ(scene.shapes, own ? Names{} : (Names{"sphere38", "sphere386"})) << name;
}

/// The file of the plan `paper` must describe the sweep that made the stores of the paper.
TEST(Plan, PaperIsWhatItsStoresHold) {
    const Plan paper = make_plan("paper");
    std::size_t next = 0;
    for (const PaperScene& wanted : paper_scenes()) {
        if (!wanted.layouts.empty() && built(wanted.layouts).empty()) continue;
        ASSERT_LT(next, paper.scenes.size());
        expect_scene(paper.scenes[next++], wanted);
    }
    EXPECT_EQ(next, paper.scenes.size());
    EXPECT_EQ(paper.shapes, (Names{"tetra4", "cube8", "sphere38", "sphere386"}));
    EXPECT_EQ(paper.layouts, built({"linked", "aos", "soa", "lean", "quantised", "points_soa"}));
    EXPECT_EQ(std::tuple(paper.seed, paper.checked, paper.control, paper.rounds, paper.count_of("stability"),
                         paper.traced, paper.traced_steps, paper.count_of("paging"), paper.meshes_required),
              std::tuple(1U, 2000U, true, 11, 100U, 3000U, 50U, 600U, false));
    EXPECT_EQ(paper.machines,
              (Names{"pentium2_deschutes", "pentium3_coppermine", "athlon_thunderbird", "zen5", "host"}));
}

/// A sign, a fraction, or more than a run can take: one line with the member and its range.
TEST_F(PlanFile, RefusesCountsThatAreNone) {
    for (const char* member :
         {"queries", "checked", "rounds", "stability", "traced", "traced_steps", "paging", "effort"}) {
        for (const char* value : {"-1", "1.5", "1e308", "9223372036854775808", "\"5\"", "[5]"}) {
            const std::string error =
                error_of(write("{\"" + std::string(member) + "\": " + std::string(value) + "}"));
            EXPECT_THAT(error, HasSubstr(std::string("mine.json: ") + member + " = ")) << value;
            EXPECT_THAT(error, HasSubstr(" to ")) << value;
        }
    }
    EXPECT_THAT(error_of(write(R"({"seed": -1})")), HasSubstr("seed = '-1'"));
    EXPECT_THAT(error_of(write(R"({"scenes": [{"name": "cold", "queries": -1}]})")),
                HasSubstr("queries = '-1'"));
    EXPECT_EQ(make_plan(write(R"({"seed": 18446744073709551615})")).seed, UINT64_MAX);
}

TEST_F(PlanFile, IsRefusedWhereItIsNestedDeeplyOrNoFile) {
    EXPECT_THAT(
        error_of(write(R"({"scenes": )" + std::string(100'000, '[') + std::string(100'000, ']') + "}")),
        HasSubstr("nested deeper than 64 levels"));
    EXPECT_THAT(error_of("/dev/zero"), HasSubstr("no regular file"));
}

TEST_F(PlanFile, OverridesWhatItNamesAndKeepsTheRestOfQuick) {
    const Plan quick = make_plan("quick");
    const Plan plan = make_plan(write(R"({"scenes": [{"name": "cold", "parameters": {"distance": 2}}],
        "shapes": ["cube8"], "meshes": [], "seed": 7, "queries": 50, "checked": 5, "rounds": 9})"));
    EXPECT_EQ(plan.name, "mine");
    ASSERT_EQ(plan.scenes.size(), 1U);
    EXPECT_EQ(plan.scenes[0].name, "cold");
    EXPECT_EQ(plan.scenes[0].parameters, (scene::SceneParameters{{"distance", 2}}));
    EXPECT_EQ(plan.shapes, std::vector<std::string>{"cube8"});
    EXPECT_TRUE(plan.meshes.empty());
    EXPECT_EQ(plan.layouts, quick.layouts);
    EXPECT_EQ(plan.algorithms, quick.algorithms);
    EXPECT_EQ(plan.seed, 7U);
    EXPECT_EQ(plan.queries, 50U);
    EXPECT_EQ(plan.checked, 5U);
    EXPECT_EQ(plan.rounds, 9);
    EXPECT_EQ(quick.processes, 3);
    EXPECT_EQ(plan.processes, 1) << "the one member that is not as in quick";
}

/// Plan quick replays a recording if layouts/sweep could make it.
TEST_F(PlanFile, LeavesOutOptionalRecordingsThatAreMissing) {
    const auto work_of = [&](const char* optional, std::vector<std::string>& said) {
        const std::string plan = write(fmt::format(
            R"({{"scenes": [{{"name": "{}/none.jsonl.gz"{}}}, {{"name": "cold"}}], "shapes": ["cube8"], "meshes": []}})",
            folder_.path().string(), optional));
        return prepare_sweep(make_plan(plan), [&](const std::string& line) { said.push_back(line); });
    };
    std::vector<std::string> said;
    EXPECT_EQ(work_of(R"(, "optional": true)", said).scenes.size(), 1U);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_THAT(said[0], HasSubstr("none.jsonl.gz is left out: there is no such recording"));
    EXPECT_THAT(complaint_of<std::invalid_argument>([&] { work_of("", said); }), HasSubstr("no such file"));
}

/// A scene file's own bodies are known where the plan names the bodies of its scene.
TEST_F(PlanFile, NamesBodiesOfItsSceneFiles) {
    folder_.write("link.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const std::string scene =
        folder_.write("links.json", R"({"scene": "cold", "shapes": ["link.obj", "cube8"]})");
    const auto work_of = [&](const char* body) {
        return prepare_sweep(
            make_plan(write(fmt::format(
                R"({{"scenes": [{{"name": "{}", "shapes": ["{}"], "caches": ["link"]}}], "meshes": []}})",
                scene, body))),
            [](const std::string&) {});
    };
    ASSERT_EQ(work_of("link").scenes.size(), 1U);
    EXPECT_EQ(work_of("link").scenes[0].shapes[0]->name, "link");
    EXPECT_THAT(complaint_of<std::invalid_argument>([&] { work_of("lnik"); }), HasSubstr("lnik"));
}

TEST_F(PlanFile, BadOnesAreOneClearLine) {
    EXPECT_THAT(error_of("nonesuch"),
                ::testing::AllOf(HasSubstr("nonesuch"), HasSubstr("quick, paper, full")));
    const std::string missing = folder_ / "gone.json";
    EXPECT_THAT(error_of(missing), HasSubstr(missing));
    const std::pair<const char*, const char*> all[] = {
        {"", ""},
        {"{", ""},
        {"[]", "the file must be one object"},
        {"null", "the file must be one object"},
        {R"({"queries": "many"})", "queries"},
        {R"({"scenes": ["tumble"]})", "scenes must be a list of objects with a name"},
        {R"({"scenes": [{}]})", "scenes must be a list of objects with a name"},
        {R"({"scenes": {"a": {"name": "cold"}}})", "scenes: type must be array, but is object"},
        {R"({"shapes": "cube8"})", "shapes: type must be array, but is string"}};
    for (const auto& [text, said] : all) {
        const std::string path = write(text);
        EXPECT_THAT(error_of(path),
                    ::testing::AllOf(HasSubstr(path), HasSubstr(said), Not(HasSubstr("json.exception"))));
        EXPECT_THAT(error_of(path), Not(HasSubstr("\n"))) << text;
    }
}

}  // namespace
}  // namespace edgewise::sweep
