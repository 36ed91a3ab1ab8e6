// SPDX-License-Identifier: MIT
//
// `edgewise lock`: the same bytes from every process, figures that other commands give as well, and what a
// check says when the lock, the body or the layout is another.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const Arguments small_lock = {"lock", "--table", "lean_f32", "--shape", "sphere38", "--queries", "200"};

json json_of_run(const Arguments& arguments, const Folder& folder) {
    const Outcome outcome = run(arguments, folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
}

TEST(Lock, IsTheSameFromEveryProcess) {
    const Folder folder;
    const Outcome first = run(small_lock, folder), second = run(small_lock, folder);
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(first.out, second.out);
    folder.write("mine.lock.json", first.out);
    const Outcome check = run({"lock", "--check", "mine.lock.json"}, folder);
    EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
    EXPECT_THAT(check.out,
                testing::MatchesRegex("mine.lock.json: passed; ([0-9]+) rows compared: [0-9]+ equal\n"));
}

TEST(Lock, HasTheFiguresOfOtherCommands) {
    const Folder folder;
    const json lock = json_of_run(small_lock, folder), figures = lock["figures"];
    const json bytes =
        json_of_run({"bytes", "--layouts", "lean_f32", "--shape", "sphere38", "--json"}, folder);
    const json& row = bytes["rows"][0];
    double sum = 0;
    for (const auto& [component, per_edge] : row["components"].items()) {
        const double in_lock = figures["bytes." + component].get<double>();
        EXPECT_NEAR(in_lock, per_edge.get<double>() * 108, 1e-6) << component;
        sum += in_lock;
    }
    EXPECT_EQ(sum, row["table_bytes"].get<double>());
    EXPECT_EQ(figures["bytes.object"].get<double>(), row["object_bytes"].get<double>());
    const json heat = json_of_run(
        {"draw", "heat", "--table", "lean_f32", "--shape", "sphere38", "--queries", "200", "--json"}, folder);
    EXPECT_EQ(figures["queries.cold"], heat["queries_by_start"]["cold"]);
    EXPECT_EQ(figures["queries.warm"], heat["queries_by_start"]["warm"]);
    EXPECT_GT(figures["lines_per_query.cold"], figures["lines_per_query.warm"]);
    EXPECT_TRUE(figures.contains("misses_per_query.zen5.L1D.warm"));
    EXPECT_EQ(lock["of"]["vertices"], "38");
}

/// As if lean_f32 had been locked and were lean_f64 now.
TEST(Lock, NamesWhatDiffers) {
    const Folder folder;
    json lock = json_of_run(small_lock, folder);
    lock["of"]["table"] = "lean_f64";
    folder.write("mine.lock.json", lock.dump());
    const Outcome layout = run({"lock", "--check", "mine.lock.json"}, folder);
    EXPECT_EQ(layout.exit_code, 1);
    EXPECT_THAT(layout.out, testing::AllOf(HasSubstr("mine.lock.json: failed; "),
                                           HasSubstr("bytes.vertex_coordinates: was 456, is 912\n"),
                                           HasSubstr("lines_per_query.cold: was ")));
    const Arguments linked = {"lock", "--table", "linked_f64", "--shape", "sphere38", "--queries", "200"};
    folder.write("linked.lock.json", run(linked, folder).out);
    EXPECT_EQ(run({"lock", "--check", "linked.lock.json"}, folder).exit_code, 0);
}

TEST(Lock, IsOfAMeshFileToo) {
    const Folder folder;
    const std::string tetrahedron =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    folder.write("mine.obj", tetrahedron);
    const Outcome lock = run({"lock", "--shape", "mine.obj", "--queries", "50"}, folder);
    ASSERT_EQ(lock.exit_code, 0) << lock.err;
    folder.write("mine.lock.json", lock.out);
    EXPECT_EQ(run({"lock", "--check", "mine.lock.json"}, folder).exit_code, 0);
    folder.write("mine.obj",
                 "v 1 1 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                 "f 2 4 3\nf 2 3 5\nf 2 5 4\nf 3 4 1\nf 4 5 1\nf 5 3 1\n");
    const Outcome check = run({"lock", "--check", "mine.lock.json", "--json"}, folder);
    EXPECT_EQ(check.exit_code, 1);
    const json found = json::parse(check.out);
    EXPECT_EQ(found["passed"], false);
    EXPECT_EQ(
        found["rows"][0],
        (json{{"outcome", "changed"}, {"cell", ""}, {"figure", "of.vertices"}, {"was", "4"}, {"is", "5"}}));
}

}  // namespace
}  // namespace edgewise::cli_test
