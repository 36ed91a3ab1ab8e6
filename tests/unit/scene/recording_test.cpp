// SPDX-License-Identifier: MIT
//
// Recordings: what the header for engines writes is read back bit by bit; a recorded scene gives the pairs
// and distances of the scene itself; every rule on pairs, caches and steps is met; and each kind of mistake
// is answered with its place.
#include "edgewise/scene/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <Eigen/Geometry>
#include <fstream>
#include <sstream>

#include "../temporary_folder.hpp"
#include "edgewise/record.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "made_scene.hpp"

namespace edgewise::scene {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Result<Recording> read(const std::string& text, const std::string& name = "mine.jsonl") {
    return read_recording(TemporaryFolder().write(name, text));
}

Recording read_well(const std::string& text) {
    auto recording = read(text);
    EXPECT_TRUE(recording) << recording.error;
    return recording ? *std::move(recording.value) : Recording{};
}

Workload replayed(const Recording& recording, SceneParameters given, std::size_t queries = 100000) {
    auto workload = recorded_workload(recording, *complete_parameters(recorded_kind, given), queries);
    EXPECT_TRUE(workload) << workload.error;
    return workload ? *std::move(workload.value) : Workload{};
}

template <class Scalar>
std::string one_hull(const std::array<Scalar, 7>& pose, const std::array<Scalar, 3>& odd) {
    std::ostringstream out;
    Recorder<Scalar> recorder(out, "an \"engine\"", 0.01, RecordedPairs::broad_phase);
    const std::array<Scalar, 3> vertices[] = {odd, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    recorder.add_hull(vertices, Scalar(0.25));
    recorder.add_box({1, 2, 3});
    recorder.add_body({.shape = 0, .link = 0});
    recorder.add_body({.shape = 1, .link = 1});
    const std::array<Scalar, 7> poses[] = {pose, {5, 0, 0, 1, 0, 0, 0}};
    const std::array<std::size_t, 2> pairs[] = {{1, 0}};
    recorder.step({.time = 0.1, .poses = poses, .pairs = pairs});
    return out.str();
}

std::string gzipped(const std::string& text) {
    const std::string path = testing::TempDir() + "packed_recording.gz";
    const gzFile file = gzopen(path.c_str(), "wb");
    gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
    gzclose(file);
    std::ostringstream bytes;
    bytes << std::ifstream(path).rdbuf();
    return bytes.str();
}

TEST(Recording, ReadsBackWhatTheHeaderForEnginesWrote) {
    const Recording of_double =
        read_well(one_hull<double>({0.1, 1e-300, -1.0 / 3, 0.5, 0.5, 0.5, 0.5}, {-0.1, -1.0 / 3, -0.7}));
    EXPECT_EQ(of_double.steps.at(0).links.at(0).translation, Vec3d(0.1, 1e-300, -1.0 / 3));
    EXPECT_EQ(of_double.cores.at(1).vertices.at(0), Vec3d(-0.1, -1.0 / 3, -0.7))
        << "boxes have more vertices";
    EXPECT_EQ(of_double.steps[0].time, 0.1);
    EXPECT_THAT(of_double.steps[0].pairs, ElementsAre(BodyPair{0, 1}));
    EXPECT_EQ(of_double.bodies.at(0).radius, 0.25);
    EXPECT_THAT(of_double.note, HasSubstr("without the radii (to 0.25) of 1 of 2 bodies"));
    const Recording of_float = read_well(
        one_hull<float>({0.1F, 1e-30F, -1.0F / 3, 0.5F, 0.5F, 0.5F, 0.5F}, {-0.1F, -1.0F / 3, -0.7F}));
    EXPECT_EQ(of_float.steps.at(0).links.at(0).translation,
              Vec3d(double{0.1F}, double{1e-30F}, double{-1.0F / 3}));
    EXPECT_EQ(of_float.cores.at(1).vertices.at(0), Vec3d(double{-0.1F}, double{-1.0F / 3}, double{-0.7F}));
}

/// The cube of `tumble` as a recording: same pairs in the same slots, same distances.
TEST(Recording, OfASceneGivesItsAnswers) {
    const Polyhedron cube = *make_shape("cube8");
    const Workload given = made_scene("tumble", cube, 1500, {{"in_time_order", 1}, {"rotation_step", 0.1}});
    std::ostringstream out;
    Recorder<double> recorder(out, "tumble", 1);
    std::vector<std::array<double, 3>> vertices;
    for (const Vec3d& v : cube.vertices) vertices.push_back({v.x(), v.y(), v.z()});
    recorder.add_hull(vertices);
    for (std::size_t i = 0; i < given.instances.size(); ++i) recorder.add_body({.shape = 0, .link = i});
    double time = 0;
    for (const Frame& frame : given.frames) {
        std::vector<std::array<double, 7>> poses;
        for (const Pose& pose : frame.poses) {
            const Eigen::Quaterniond q(pose.rotation);
            const Vec3d& t = pose.translation;
            poses.push_back({t.x(), t.y(), t.z(), q.w(), q.x(), q.y(), q.z()});
        }
        recorder.step({.time = time++, .poses = poses, .jump = frame.starts_anew});
    }
    const Workload made = replayed(read_well(out.str()), {{"rate", 0}, {"margin", 0.2}});
    ASSERT_GE(made.queries.size(), given.queries.size()) << "the scene's last step was cut short";
    for (std::size_t i = 0; i < given.queries.size(); ++i) {
        const Query &a = given.queries[i], &b = made.queries[i];
        ASSERT_EQ(std::tie(a.pair, a.instance_a, a.instance_b), std::tie(b.pair, b.instance_a, b.instance_b))
            << i;
        if (i % 10 == 0) {
            EXPECT_NEAR(distance_of(given, a), distance_of(made, b), 1e-12) << i;
        }
    }
    EXPECT_EQ(made.frames.size(), given.frames.size());
}

constexpr const char* boxes =
    R"({"format":"convex-motion","version":0,"shapes":[{"type":"box","half":[1,1,1]},{"type":"plane"},)"
    R"({"type":"capsule","half_length":1,"radius":0.5},{"type":"sphere","radius":2}],"bodies":[)"
    R"({"shape":0,"link":0},{"shape":0,"link":1},{"shape":2,"link":2},{"shape":1,"link":3},{"shape":3,"link":3}]})"
    "\n";

std::string step(double t, const std::string& more = "", double x = 2.01) {
    std::ostringstream line;
    line << R"({"t":)" << t << R"(,"poses":[[0,0,0,1,0,0,0],[)" << x << R"(,0,0,1,0,0,0],[0,0,3,1,0,0,0],)"
         << "[0,9,0,1,0,0,0]]" << more << "}\n";
    return line.str();
}

std::vector<BodyPair> pairs_of(const Workload& workload) {
    std::vector<BodyPair> pairs;
    for (const Query& query : workload.queries) pairs.push_back({query.instance_a, query.instance_b});
    return pairs;
}

TEST(Recording, LeavesOutShapesWithoutAPolytope) {
    const Recording recording = read_well(boxes + step(0));
    EXPECT_EQ(recording.bodies.size(), 4U);
    EXPECT_EQ(recording.cores.size(), 3U) << "two boxes share one, a segment, a point";
    EXPECT_EQ(recording.cores.front().vertex_count(), 8U) << "the one with most vertices is the first";
    EXPECT_THAT(recording.note, HasSubstr("(1 plane)"));
    std::string text = boxes + step(0, R"(,"pairs":[[0,1],[1,0],[0,3]])");
    text.replace(text.find(R"("version":0)"), 11, R"("version":0,"pairs":"broad_phase")");
    const Recording with_pairs = read_well(text);
    EXPECT_THAT(with_pairs.steps[0].pairs, ElementsAre(BodyPair{0, 1})) << "each once";
    EXPECT_THAT(with_pairs.note, HasSubstr("with 1 of the file's pairs"));
    EXPECT_THAT(pairs_of(replayed(with_pairs, {})), ElementsAre(BodyPair{0, 1}));
    EXPECT_GT(replayed(with_pairs, {{"own_pairs", 1}, {"margin", 1}}).queries.size(), 1U);
}

/// A radius enlarges the box: the capsule's core ends at 2, and the box below it at 1.
TEST(Recording, FindsPairsByMarginAndRadius) {
    EXPECT_THAT(pairs_of(replayed(read_well(boxes + step(0)), {})), ElementsAre(BodyPair{0, 1}));
    EXPECT_EQ(replayed(read_well(boxes + step(0)), {{"margin", 0.2}}).queries.size(), 3U);
    const auto none = recorded_workload(read_well(boxes + step(0)),
                                        *complete_parameters(recorded_kind, {{"margin", 0}}), 10);
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error, HasSubstr("recording mine: no pair is near in 1 steps; raise margin"));
}

TEST(Recording, NeverAsksForbiddenPairs) {
    const auto count = [](const std::string& body, const std::string& header, const std::string& line) {
        std::string text = boxes + step(0, line) + step(1, "", 2.0);
        text.replace(text.find(R"({"shape":0,"link":1})"), 20, body);
        text.replace(text.find(R"("version":0)"), 11, R"("version":0)" + header);
        const auto made =
            recorded_workload(read_well(text), *complete_parameters(recorded_kind, {{"rate", 0}}), 99);
        return made ? made->queries.size() : 0;
    };
    EXPECT_EQ(count(R"({"shape":0,"link":1})", "", ""), 2U);
    EXPECT_EQ(count(R"({"shape":0,"link":1,"parent":0})", "", ""), 0U);
    EXPECT_EQ(count(R"({"shape":0,"link":1,"group":2,"mask":2})", "", ""), 2U) << "a's mask has group 2";
    EXPECT_EQ(count(R"({"shape":0,"link":1,"group":0,"mask":2})", "", ""), 0U);
    EXPECT_EQ(count(R"({"shape":0,"link":1})", R"(,"excluded":[[1,0]])", ""), 0U);
    EXPECT_EQ(count(R"({"shape":0,"link":1})", "", R"(,"asleep":[0,1])"), 1U)
        << "both sleep in the first step";
    EXPECT_EQ(count(R"({"shape":0,"link":1,"fixed":true})", "", R"(,"asleep":[0])"), 1U);
    EXPECT_EQ(count(R"({"shape":0,"link":0})", "", ""), 0U) << "one link";
}

TEST(Recording, KeepsCachesUntilAPairLeavesOrAJump) {
    const Workload made = replayed(read_well(boxes + step(0) + step(1) + step(2, "", 9) + step(3) +
                                             step(4, R"(,"jump":true)") + step(5)),
                                   {{"rate", 0}});
    std::vector<std::uint32_t> slots;
    for (const Query& query : made.queries) slots.push_back(query.pair);
    EXPECT_THAT(slots, ElementsAre(0, 0, 1, 2, 2));
    EXPECT_TRUE(made.warm);
    EXPECT_EQ(made.frames.size(), 6U);
    EXPECT_TRUE(made.frames[4].starts_anew);
    EXPECT_FALSE(made.frames[5].starts_anew);
}

TEST(Recording, MovesOnlyTheLinksThatMoved) {
    const Recording recording =
        read_well(boxes + step(0) + R"({"t":1,"moved":[1],"poses":[[7,0,0,1,0,0,0]]})" + "\n");
    EXPECT_EQ(recording.steps[1].links[1].translation, Vec3d(7, 0, 0));
    EXPECT_EQ(recording.steps[1].links[2].translation, recording.steps[0].links[2].translation);
}

TEST(Recording, IsThinnedByRateAndBySegments) {
    std::string text = boxes;
    for (int i = 0; i < 100; ++i) text += step(i * 0.01, i == 51 ? R"(,"jump":true)" : "");
    const Recording recording = read_well(text);
    EXPECT_EQ(replayed(recording, {{"rate", 0}}).frames.size(), 100U);
    const Workload slower = replayed(recording, {{"rate", 50}});
    EXPECT_EQ(slower.frames.size(), 50U);
    EXPECT_TRUE(slower.frames[26].starts_anew) << "the jump lies between two steps that are taken";
    EXPECT_EQ(replayed(recording, {{"rate", 0}, {"seconds", 0.095}}).frames.size(), 10U);
    const auto some = recorded_workload(recording, *complete_parameters(recorded_kind, {{"rate", 0}}), 40);
    ASSERT_TRUE(some) << some.error;
    EXPECT_EQ(some->queries.size(), 40U);
    EXPECT_THAT(some.warning, HasSubstr("40 of 100 steps are asked, 4 times 10 in a row"));
    EXPECT_TRUE(some->frames[10].starts_anew && some->frames[30].starts_anew);
    EXPECT_EQ(some->queries.back().pose_b.translation, recording.steps.back().links[1].translation);
}

TEST(Recording, IsReadFromGzip) {
    const std::string text = boxes + step(0) + step(1);
    const auto packed = read(gzipped(text), "mine.jsonl.gz");
    ASSERT_TRUE(packed) << packed.error;
    EXPECT_EQ(packed->checksum, read_well(text).checksum);
    EXPECT_EQ(packed->name, "mine");
    const std::string bytes = gzipped(text);
    const auto cut = read(bytes.substr(0, bytes.size() - 20), "mine.jsonl.gz");
    ASSERT_FALSE(cut);
    EXPECT_THAT(cut.error, HasSubstr("the gzip data is cut off or damaged"));
}

struct BadRecording {
    std::string from, to;  ///< a replacement in a good recording
    const char* said;
};

const BadRecording bad_recordings[] = {
    {"convex-motion", "concave", R"(:1: is no recording: the first line must have "format")"},
    {R"("version":0)", R"("version":9)", ":1: version 9 is not known: this program reads version 0"},
    {R"("version":0)", R"("version":0,"pairs":"contact")",
     ":1: unknown pairs 'contact'; did you mean 'contacts'?"},
    {R"("half":[1,1,1])", R"("half":[1,1])", ":1: shapes[0].half has 2 numbers and needs 3"},
    {R"("half":[1,1,1])", R"("half":[1,1,-1])", ":1: shapes[0].half has a number below 0"},
    {R"("half":[1,1,1])", R"("whole":[1,1,1])", ":1: shapes[0].half is missing"},
    {R"({"type":"plane"})", R"({"kind":"plane"})", ":1: shapes[1].type is missing"},
    {R"({"type":"plane"})", R"({"type":"hull","vertices":[]})", ":1: bodies[3]"},
    {R"({"type":"plane"})", R"({"type":"mesh","file":"none.stl"})", "none.stl"},
    {R"("radius":2)", R"("radius":-2)", ":1: shapes[3].radius = -2 must be a number from 0 on"},
    {R"("radius":2)", R"("r":2)", ":1: shapes[3].radius is missing"},
    {R"("version":0)", R"("version":0,"excluded":{"a":[0,1]})", ":1: excluded is not an array"},
    {R"({"shape":2,)", R"({"parent":9,"shape":2,)", ":1: parent 9 is none of the 4 links"},
    {R"({"shape":1,)", R"({"shape":7,)", ":1: bodies[3].shape is 7, but there are 4 shapes"},
    {R"({"shape":1,)", R"({)", ":1: bodies[3].shape is missing"},
    {R"({"shape":2,)", R"({"scale":[1,2,1],"shape":2,)", ":1: bodies[2].scale stretches a rounded shape"},
    {R"({"shape":0,)", R"({"scale":[1,-1,1],"shape":0,)", ":1: bodies[0].scale must be above 0"},
    {R"({"shape":0,)", R"({"pose":[0,0,0,0,0,0,0],"shape":0,)",
     ":1: bodies[0].pose has a quaternion of length 0"},
    {R"("t":1)", R"("t":-1)", R"(:3: t = -1 is before the step before: a reset needs "jump": true)"},
    {R"("t":1)", R"("s":1)", ":3: t is missing"},
    {R"("t":1,"poses":[)", R"("t":1,"poses":[[0,0,0,1,0,0,0],)",
     ":3: poses has 5 poses and needs 4, one for each link"},
    {R"("t":1,"poses":[[0,0,0,1)", R"("t":1,"poses":[[0,0,0,2)", ":3: poses[0] has a quaternion of length 2"},
    {R"("t":1,"poses":[[0)", R"("t":1,"poses":[[null)", ":3: poses[0][0] is not a finite number"},
    {R"("t":1,"poses":[[0)", R"("t":1,"poses":[[1e999)", ":3: a number is too large for double precision"},
    {R"("t":1,"poses":[[0)", R"("t":1,"poses":[[NaN)", ":3: not JSON at column"},
    {R"("t":0,)", R"("t":0,"moved":[0,1,2,3],)", ":2: moved: the first step needs the poses of all links"},
    {R"("t":1,)", R"("t":1,"asleep":[4],)", ":3: asleep[0] is 4, but there are 4 links"},
    {R"("t":1,)", R"("t":1,"asleep":true,)", ":3: asleep is not an array"},
    {R"("t":1,)", R"("t":1,"moved":1,)", ":3: moved is not an array"},
    {R"("t":1,)", R"("t":1,"moved":[0,1,2,0],)", ":3: moved names link 0 twice"},
    {R"("t":1,)", R"("t":1,"pairs":[[0,1]],)", R"(:3: pairs: the header says "none")"},
    {"\n{\"t\":1", std::string(1, '\0') + "\n{\"t\":1", ":2: a zero byte: the file was cut off or damaged"},
    {R"("t":1,)", R"("t":1,"pairs":[[0,9]],)", ":3: pairs[0] is 9, but there are 5 bodies"},
    {R"("t":1,)", R"("t":1,"pairs":[[1,1]],)", ":3: pairs[0] pairs body 1 with itself"},
    {R"("t":1,)", R"("t":1,"contacts":[[1,2]],)", ":3: contacts[0] is not an array of 3 numbers"},
    {R"("t":1,)", R"("t":1,"t":1,)", ":3: t is given twice"},
    {R"("t":1,)", R"("t":1,"jump":1,)", ":3: jump is neither true nor false"},
    {"[0,9,0,1,0,0,0]]}\n{\"t\":1", "[0,9,0,1,0,0,0]]}\n[1]\n{\"t\":1", ":3: the line is not a JSON object"}};

TEST(Recording, SaysWhereAMistakeIs) {
    const std::string good = boxes + step(0) + step(1);
    for (const BadRecording& bad : bad_recordings) {
        std::string text = good;
        ASSERT_NE(text.find(bad.from), std::string::npos) << bad.from;
        const auto recording = read(text.replace(text.find(bad.from), bad.from.size(), bad.to));
        ASSERT_FALSE(recording) << bad.to;
        EXPECT_THAT(recording.error, HasSubstr(bad.said)) << bad.to;
        EXPECT_EQ(recording.error.find('\n'), std::string::npos);
    }
    EXPECT_THAT(read(good.substr(0, good.size() - 30)).error, HasSubstr(":3: the line is cut off"));
    EXPECT_THAT(read(boxes).error, HasSubstr("there is no step after the header"));
    EXPECT_THAT(read_recording("none.jsonl").error, HasSubstr("none.jsonl: no such file"));
}

TEST(Recording, IgnoresUnknownMembers) {
    std::string text = boxes + step(0, R"(,"mood":"calm")");
    text.replace(text.find(R"("version":0)"), 11, R"("version":0,"colour":"red")");
    EXPECT_EQ(read_well(text).bodies.size(), 4U);
}

TEST(Recorder, RefusesBadCalls) {
    using Calls = std::function<void(Recorder<double>&)>;
    const std::array<double, 7> at_rest = {0, 0, 0, 1, 0, 0, 0};
    const std::vector<std::array<double, 7>> poses = {at_rest}, two = {at_rest, at_rest};
    const std::vector<std::array<double, 7>> endless = {{0, INFINITY, 0, 1, 0, 0, 0}}, flat = {{}};
    const std::vector<std::array<std::size_t, 2>> pairs = {{0, 1}}, self = {{0, 0}};
    const std::pair<Calls, const char*> all[] = {
        {[&](auto& r) { r.step({.time = 0, .poses = two}); }, "2 poses of 1 links"},
        {[&](auto& r) { r.step({.time = 0, .poses = endless}); }, "poses[0] is not finite"},
        {[&](auto& r) { r.step({.time = NAN, .poses = poses}); }, "time is not finite"},
        {[&](auto& r) { r.step({.time = 0, .poses = flat}); }, "no unit quaternion"},
        {[&](auto& r) { r.step({.time = 0, .poses = poses, .pairs = pairs}); }, "pairs[0] is number 1 of 1"},
        {[&](auto& r) { r.add_body({.shape = 3}); }, "shape is number 3 of 1"},
        {[&](auto& r) { r.add_sphere(-1); }, "a radius is below 0"},
        {[&](auto& r) { r.add_hull({}); }, "a hull has no vertices"},
        {[&](auto& r) { r.add_capsule(-1, 1); }, "a half length of a capsule is below 0"},
        {[&](auto& r) {
             r.add_body({.shape = 0, .scale = {-1, 1, 1}});
         },
         "mirror its vertices"},
        {[&](auto& r) { r.exclude(0, 4), r.step({.time = 0, .poses = poses}); },
         "link 4 is a parent or excluded"},
        {[&](auto& r) { r.step({.time = 0, .poses = poses, .pairs = self}); }, "a body with itself"},
        {[&](auto& r) { r.step({.time = 1, .poses = poses}), r.step({.time = 0, .poses = poses}); },
         "time goes back without a jump"},
        {[&](auto& r) { r.step({.time = 1, .poses = poses}), r.add_body({}); }, "after the first step"}};
    for (const auto& [call, said] : all) {
        std::ostringstream out;
        Recorder<double> recorder(out, "mine", 0.01, RecordedPairs::broad_phase);
        recorder.add_box({1, 1, 1});
        recorder.add_body({.shape = 0, .link = 0});
        try {
            call(recorder);
            ADD_FAILURE() << "not refused: " << said;
        } catch (const std::invalid_argument& refusal) {
            EXPECT_THAT(refusal.what(), HasSubstr(said));
        }
    }
}

TEST(RecordedScene, IsNamedInASceneFileOrByItself) {
    const TemporaryFolder folder;
    const auto direct = find_scene_file(folder.write("mine.jsonl", boxes + step(0) + step(1)));
    ASSERT_TRUE(direct && *direct) << (*direct).error;
    EXPECT_EQ((*direct)->name, "mine");
    EXPECT_EQ((*direct)->kind, recorded_kind);
    EXPECT_EQ((*direct)->shapes.front().body.vertex_count(), 8U);
    EXPECT_GT((*direct)->points.front().parameters.at("recording"), 0);
    const auto no_utf8 = find_scene_file(folder.write("min\xff.jsonl", boxes + step(0)));
    EXPECT_TRUE(no_utf8 && *no_utf8) << (*no_utf8).error;
    const SceneFileContext here{.folder = folder.path()};
    const auto parsed = [&](const std::string& more) {
        return parse_scene_file("mine", R"({"scene": "recorded", "recording": "mine.jsonl")" + more + "}",
                                here);
    };
    const auto varied = parsed(R"(, "vary": {"rate": [0, 30]}, "sharing": "per_instance")");
    ASSERT_TRUE(varied) << varied.error;
    EXPECT_EQ(varied->points.size(), 2U);
    EXPECT_EQ(varied->points[1].parameters.at("own_tables"), 1);
    EXPECT_THAT(parsed(R"(, "shapes": ["cube8"])").error, HasSubstr("shapes is in the recording"));
    EXPECT_THAT(parsed(R"(, "parameters": {"recording": 1})").error, HasSubstr("both say what recording is"));
    EXPECT_THAT(parsed(R"(, "parameters": {"rat": 1})").error, HasSubstr("did you mean 'rate'?"));
    EXPECT_THAT(parse_scene_file("mine", R"({"scene": "tumble", "recording": "mine.jsonl"})", here).error,
                HasSubstr("belong together"));
    EXPECT_THAT(parse_scene_file("mine", R"({"scene": "recorded", "shapes": ["cube8"]})", here).error,
                HasSubstr("belong together"));
    SceneFileContext with_bodies = here;
    with_bodies.bodies.push_back({"cube8", "built-in", *make_shape("cube8"), {}});
    EXPECT_THAT(
        parse_scene_file("mine", R"({"scene": "recorded", "recording": "mine.jsonl"})", with_bodies).error,
        HasSubstr("name none with --shape"));
    const auto nothing = make_scene(recorded_kind, *make_shape("cube8"), {}, 1, 10, {});
    ASSERT_FALSE(nothing);
    EXPECT_THAT(nothing.error, HasSubstr("scene 'recorded' is of a file"));
}

TEST(RecordedScene, TakesNoMarginThatItsPairsDoNotUse) {
    const TemporaryFolder folder;
    const SceneFileContext here{.folder = folder.path()};
    std::string engines = boxes + step(0, R"(,"pairs":[[0,1]])");
    folder.write("pairs.jsonl",
                 engines.replace(engines.find(R"("version":0)"), 11, R"("version":0,"pairs":"broad_phase")"));
    const auto with_margin = [&](const std::string& own_pairs) {
        return parse_scene_file("mine",
                                R"({"scene": "recorded", "recording": "pairs.jsonl", "parameters": {)" +
                                    own_pairs + R"("margin": 0.1}})",
                                here);
    };
    EXPECT_THAT(with_margin("").error, HasSubstr("write own_pairs = 1 too"));
    EXPECT_EQ(with_margin(R"("own_pairs": 1, )").error, "");
}

}  // namespace
}  // namespace edgewise::scene
