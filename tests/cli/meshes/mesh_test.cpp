// SPDX-License-Identifier: MIT
//
// Mesh files in every command that takes them: the same file is the same body, or refused with the same line,
// and what was done to it is said.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli_paths.hpp"
#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr const char* corner_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A cube of 0.3 m at UTM coordinates: single precision there has steps of 0.5 m.
std::string utm_points(const char* before) {
    std::string text;
    for (const char* x : {"345678.12300000002", "345678.42300000001"})
        for (const char* y : {"5812345.6780000003", "5812345.9780000001"})
            for (const char* z : {"34.560000000000002", "34.859999999999999"})
                text += std::string(before) + x + " " + y + " " + z + "\n";
    return text;
}
constexpr double utm_size = 0.5196152;  ///< 0.3 times the root of 3

/// A box 1 x 1 x 2 with z up, in millimetres.
std::string collada_box() {
    return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.001"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="a" count="24">0 0 0 0 0 2 0 1 0 0 1 2 1 0 0 1 0 2 1 1 0 1 1 2</float_array>
<technique_common><accessor source="#a" count="8" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/>
<p>0 1 3 0 3 2 4 6 7 4 7 5 0 4 5 0 5 1 2 3 7 2 7 6 0 2 6 0 6 4 1 5 7 1 7 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";
}

/// Every command that reads a mesh file, as short as it can be.
std::vector<Arguments> commands_on(const std::string& file) {
    return {{"bytes", "--mesh", file, "--layouts", "lean_f64"},
            {"advise", "budget", "--mesh", file, "--table", "lean_f64"},
            {"judge", "--a", file, "--b", file, "--layouts", "lean_f64"},
            {"lock", "--shape", file, "--table", "lean_f64", "--queries", "10"},
            {"sweep", "--mesh", file, "--scenes", "static", "--layouts", "aos_f64", "--queries", "4",
             "--checked", "2", "--rounds", "1", "--no-report", "--store", "sweep.db"},
            {"stability", "--mesh", file, "--families", "real_hulls_at_gaps", "--count", "1", "--proofs", "0",
             "--layouts", "aos_f64", "--store", "stability.db"},
            {"advise", "--mesh", file, "--bodies", "2", "--time", "5"}};
}

/// Lines of people's output that are about the mesh.
std::vector<std::string> said_of(const std::string& file, const Outcome& outcome) {
    std::vector<std::string> said;
    for (const std::string& line : lines_of(outcome.err))
        if (line.find(file) != line.npos) said.push_back(line);
    return said;
}

TEST(Mesh, EveryCommandRefusesABrokenFileAlike) {
    const Folder folder;
    const std::pair<std::string, std::string> files[] = {
        {"comma.obj", "v 0,5 0 0\n"},
        {"far.obj", std::string(corner_obj) + "f 1 2 5\n"},
        {"short.stl", "solid a\nfacet normal 0 0 1\n"},
        {"no.ply",
         "ply\nformat ascii 1.0\nelement vertex 2\n"
         "property float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n"}};
    for (const auto& [name, text] : files) {
        folder.write(name, text);
        std::string first;
        for (const Arguments& command : commands_on(name)) {
            const Outcome outcome = run(command, folder);
            EXPECT_EQ(outcome.exit_code, 2) << command[0];
            EXPECT_EQ(outcome.out, "") << command[0];
            if (first.empty()) first = outcome.err;
            EXPECT_EQ(outcome.err, first) << command[0];
            EXPECT_THAT(outcome.err, HasSubstr(name)) << command[0];
            EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
        }
    }
}

/// One line before all else, from every command, however often it reads the file; none with --as-stored,
/// which all have.
TEST(Mesh, EveryCommandSaysWhatAColladaFileDoes) {
    const Folder folder;
    folder.write("link.dae", collada_box());
    const std::string line =
        "edgewise: link.dae: turned from Z up to Y up and scaled by 0.001 as the file says; --as-stored leaves both "
        "out";
    for (const Arguments& command : commands_on("link.dae")) {
        const Outcome turned = run(command, folder);
        EXPECT_NE(turned.exit_code, 2) << command[0] << turned.err;
        const auto said = said_of("link.dae", turned);
        EXPECT_THAT(said, testing::Each(line)) << command[0];
        EXPECT_EQ(said.size(), 1U) << command[0] << turned.err;
        const Outcome stored = run(with(command, {"--as-stored"}), folder);
        EXPECT_NE(stored.exit_code, 2) << command[0] << stored.err;
        EXPECT_THAT(stored.err, Not(HasSubstr("link.dae"))) << command[0];
    }
}

/// The program of these tests has no report, by which advice is ranked: what advise says first is asked.
TEST(Mesh, ARecordingsFileIsTurnedOrAsStored) {
    const Folder folder;
    folder.write("link.dae", collada_box());
    std::string recording =
        R"({"format":"convex-motion","version":0,"shapes":[{"type":"mesh","file":"link.dae"}],)"
        R"("bodies":[{"shape":0},{"shape":0}]})";
    for (const char* step :
         {R"({"t":0,"poses":[[0,0,0,1,0,0,0],[0.00101)", R"({"t":1,"poses":[[0,0,0,1,0,0,0],[0.00102)"})
        recording += std::string("\n") + step + ",0,0,1,0,0,0]]}";
    folder.write("links.jsonl", recording + "\n");
    for (const Arguments& command :
         {Arguments{"lock", "--scene", "links.jsonl", "--table", "lean_f64", "--queries", "3"},
          Arguments{"advise", "--scene", "links.jsonl", "--time", "5"}}) {
        const Outcome turned = run(command, folder);
        EXPECT_NE(turned.exit_code, 2) << command[0] << turned.err;
        EXPECT_THAT(turned.err, HasSubstr("link.dae: turned from Z up")) << command[0];
        const Outcome stored = run(with(command, {"--as-stored"}), folder);
        EXPECT_NE(stored.exit_code, 2) << command[0] << stored.err;
        EXPECT_THAT(stored.err, Not(HasSubstr("link.dae"))) << command[0];
        if (command[0] == "lock") {
            EXPECT_NE(stored.out, turned.out);
        }
    }
}

TEST(Mesh, AsStoredIsTheTwinInAnotherFormat) {
    const Folder folder;
    folder.write("link.dae", collada_box());
    folder.write("point.obj", "v 0 0 5\n");
    const Arguments judge = {"judge",     "--a",       "link.dae", "--b",
                             "point.obj", "--layouts", "aos_f64",  "--json"};
    EXPECT_NEAR(json::parse(run(judge, folder).out)["exact"]["distance"].get<double>(), 5, 1e-6)
        << "z is from -0.001 to 0, as the file says";
    EXPECT_EQ(json::parse(run(with(judge, {"--as-stored"}), folder).out)["exact"]["distance"], 3);
    const Outcome lock = run({"lock", "--shape", "link.dae", "--as-stored", "--queries", "10"}, folder);
    EXPECT_EQ(json::parse(lock.out)["of"]["as_stored"], "yes");
    folder.write("link.lock.json", lock.out);
    const Outcome check = run({"lock", "--check", "link.lock.json"}, folder);
    EXPECT_EQ(check.exit_code, 0) << check.out;
    EXPECT_THAT(check.err, Not(HasSubstr("turned")));
}

TEST(Mesh, AnObjIsReadInDouble) {
    const Folder folder;
    folder.write("utm.obj", utm_points("v "));
    for (const Arguments& command : commands_on("utm.obj")) {
        if (command[0] == "advise") continue;
        EXPECT_THAT(run(command, folder).err, Not(HasSubstr("single precision"))) << command[0];
    }
    const json budget = json::parse(
        run({"advise", "budget", "--mesh", "utm.obj", "--tolerance", "0.001", "--json"}, folder).out);
    EXPECT_NEAR(budget["size"].get<double>(), utm_size, 1e-6);
    EXPECT_EQ(budget["read_in"], "double");
    EXPECT_EQ(budget["answer"]["vertices"], 8);
    folder.write("beside.obj", "v 345678.92300000002 5812345.6780000003 34.560000000000002\n");
    const json pair = json::parse(
        run({"judge", "--a", "utm.obj", "--b", "beside.obj", "--layouts", "aos_f64", "--json"}, folder).out);
    EXPECT_NEAR(pair["exact"]["distance"].get<double>(), 0.5, 1e-9);
}

TEST(Mesh, SaysThatSinglePrecisionIsTooCoarse) {
    const Folder folder;
    folder.write("utm.ply",
                 "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\n"
                 "property double z\nend_header\n" +
                     utm_points(""));
    for (const Arguments& command : commands_on("utm.ply")) {
        if (command[0] == "advise") continue;
        EXPECT_THAT(
            said_of("utm.ply", run(command, folder)),
            testing::Contains(HasSubstr("utm.ply: read in single precision, whose steps of 0.5 there")))
            << command[0];
    }
    const Arguments budget = {"advise", "budget", "--mesh", "utm.ply", "--tolerance", "0.001"};
    std::string text = run(budget, folder).out;
    std::ranges::replace(text, '\n', ' ');
    EXPECT_THAT(text,
                HasSubstr("exact for the body as it was read, in single precision (steps of 0.5 here)"));
    EXPECT_EQ(json::parse(run(with(budget, {"--json"}), folder).out)["read_in"], "single");
}

TEST(Mesh, JudgeTakesFlatMeshesOfEveryFormat) {
    const Folder folder;
    folder.write("flat.obj", "v -5 -5 0\nv 5 -5 0\nv -5 5 0\nv 5 5 0\nf 1 2 3\nf 2 4 3\n");
    folder.write("flat.stl",
                 "SOLID\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX -5 -5 0\nVERTEX 5 -5 0\nVERTEX -5 5 0\n"
                 "ENDLOOP\nENDFACET\nfacet normal 0 0 1 outer loop vertex 5 -5 0 vertex 5 5 0 vertex -5 5 0 "
                 "endloop endfacet\nENDSOLID\n");
    folder.write("point.obj", "o point\nv 1 2 3\n");
    for (const char* name : {"flat.obj", "flat.stl"}) {
        const Outcome outcome =
            run({"judge", "--a", name, "--b", "point.obj", "--layouts", "aos_f64", "--json"}, folder);
        ASSERT_NE(outcome.exit_code, 2) << outcome.err;
        EXPECT_EQ(json::parse(outcome.out)["exact"]["distance"], 3) << name;
        EXPECT_THAT(run({"bytes", "--mesh", name}, folder).err,
                    testing::AllOf(HasSubstr("flat: all 4 vertices lie in one plane"),
                                   HasSubstr("judge takes flat")));
    }
}

/// Points of an OBJ text, one for each of its lines of vertices.
std::vector<std::vector<double>> obj_points(const std::string& text) {
    std::vector<std::vector<double>> points;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("v ")) continue;
        std::istringstream numbers(line.substr(2));
        std::vector<double> point(3);
        for (double& number : point) numbers >> number;
        points.push_back(point);
    }
    std::ranges::sort(points);
    return points;
}

/// Includes cubes, cylinders and prisms, which have their farthest four vertices in one plane.
TEST(Budget, WritesASmallerBodyThatIsReadBack) {
    const Folder folder;
    std::string barrel = "o barrel\n";
    for (int i = 0; i < 24; ++i) {
        const double angle = 2 * M_PI * i / 24;
        for (const int z : {0, 2})
            barrel += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " " +
                      std::to_string(z) + "\n";
    }
    folder.write("barrel.obj", barrel);
    folder.write("utm.obj", utm_points("v "));
    for (const Arguments& body : {Arguments{"--shape", "cube8"},
                                  {"--shape", "sphere98"},
                                  {"--mesh", "barrel.obj"},
                                  {"--mesh", "utm.obj"}}) {
        for (const Arguments& limit : {Arguments{"--vertices", "6"},
                                       {"--tolerance", "0.05"},
                                       {"--vertices", "4"},
                                       {"--vertices", "100", "--tolerance", "0.01"},
                                       {"--vertices", "1000"}}) {
            const Outcome outcome =
                run(with({"advise", "budget", "--out", "reduced.obj", "--json"}, with(body, limit)), folder);
            ASSERT_EQ(outcome.exit_code, 0) << outcome.err << body[1] << limit[1];
            const json budget = json::parse(outcome.out);
            auto points = budget["answer"]["points"].get<std::vector<std::vector<double>>>();
            std::ranges::sort(points);
            EXPECT_EQ(obj_points(text_of(folder / "reduced.obj")), points) << body[1] << limit[1];
            EXPECT_LE(points.size(), limit[0] == "--vertices" ? std::stoul(limit[1]) : 98U);
            EXPECT_EQ(budget["answer"]["within"], true);
            const Outcome again =
                run({"bytes", "--mesh", "reduced.obj", "--layouts", "lean_f64", "--json"}, folder);
            EXPECT_EQ(again.err, "") << "closed and convex";
            EXPECT_EQ(json::parse(again.out)["rows"][0]["vertices"], points.size());
        }
    }
}

TEST(Budget, SaysThatACountIsNotEnoughForATolerance) {
    const Folder folder;
    const Arguments command = {"advise",     "budget", "--shape",     "sphere98",
                               "--vertices", "8",      "--tolerance", "0.001"};
    const Outcome outcome = run(command, folder);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.out, HasSubstr("at 0.001 and at most 8 vertices: 8 vertices are not enough"));
}

/// Reports name the bodies of plan `quick` by their files alone, and print commands with these names.
TEST(Meshes, ThatPlansBringAreFoundByTheirName) {
    const Folder folder;
    const auto own = std::filesystem::path(program_path).parent_path().parent_path() / "meshes/hubo_foot.stl";
    const Outcome outcome = run({"bytes", "--shape", "hubo_foot.stl", "--layouts", "lean_f64"}, folder);
    EXPECT_EQ(outcome.exit_code, std::filesystem::exists(own) ? 0 : 2) << outcome.err;
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("hubo_foot"));
    folder.write("hubo_foot.stl", "no mesh");
    EXPECT_EQ(run({"bytes", "--shape", "hubo_foot.stl"}, folder).exit_code, 2)
        << "a file that is here goes before";
}

}  // namespace
}  // namespace edgewise::cli_test
