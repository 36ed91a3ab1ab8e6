// SPDX-License-Identifier: MIT
//
// `edgewise bench gate`: a baseline is written and compared with, and what it names. No test here depends
// on how long anything takes: slacks are huge, and a slower entry has a baseline that was made tiny.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const Arguments gate_arguments = {"bench",     "gate", "b.json",    "--rounds", "6",
                                  "--queries", "200",  "--layouts", "lean_f64"};

TEST(BenchGate, ComparesWithWhatItWrote) {
    const Folder folder;
    const Outcome written = run(with(gate_arguments, {"--write", "--slack", "50"}), folder);
    ASSERT_EQ(written.exit_code, 0) << written.err;
    json baseline = json::parse(text_of(folder / "b.json"));
    EXPECT_EQ(baseline["slack"], 50);
    EXPECT_EQ(baseline["with"]["rounds"], "6");
    // 15 groups of a reference, V-Clip and GJK; GJK's batches in the three that are cold.
    EXPECT_EQ(baseline["cells"].size(), 15u * 3 + 3);

    const Outcome same = run(with(gate_arguments, {"--json"}), folder);
    ASSERT_EQ(same.exit_code, 0) << same.out << same.err;
    EXPECT_EQ(json::parse(same.out)["compared"], baseline["cells"].size() + 1) << "and the queries";

    const std::string slowed = "gjk lean_f64 cold cube8";
    baseline["cells"][slowed]["time over reference"] = {1e-10, 1e-10, 1e-10};
    baseline["cells"]["gjk lean_f64 gone cube8"] = baseline["cells"]["vclip lean_f64 cold cube8"];
    baseline["cells"].erase("vclip lean_f64 cold cube8");
    baseline["with"]["machine"] = "another machine of mine";
    folder.write("b.json", baseline.dump());
    const Outcome slower = run(gate_arguments, folder);
    EXPECT_EQ(slower.exit_code, 1) << slower.err;
    EXPECT_THAT(lines_of(slower.out).front(),
                testing::StartsWith("worse: " + slowed + ": time over reference: was "));
    EXPECT_THAT(slower.out, HasSubstr("missing: gjk lean_f64 gone cube8\n"));
    EXPECT_THAT(slower.out, HasSubstr("new: vclip lean_f64 cold cube8\n"));
    EXPECT_THAT(slower.out, HasSubstr("possible cause: machine: was another machine of mine"));
    EXPECT_THAT(slower.out, HasSubstr(": 1 worse"));
}

}  // namespace
}  // namespace edgewise::cli_test
