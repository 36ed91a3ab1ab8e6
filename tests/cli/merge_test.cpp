// SPDX-License-Identifier: MIT
//
// A campaign in parts and merged is the campaign of one process in every figure that repeats; parts that were
// stopped are named, and go on; figures of merit are lines that a harness can read.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli_paths.hpp"
#include "deterministic_figures.hpp"
#include "program.hpp"
#include "sweep_store.hpp"
#include "tiny_plan.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

class Merge : public testing::Test {
  protected:
    void SetUp() override { folder_.write("tiny.json", tiny_plan); }

    Outcome shard(const std::string& text, const std::string& store, const Arguments& more = {}) {
        return run(with({"sweep", "--plan", "tiny.json", "--shard", text, "--store", store, "--json"}, more),
                   folder_);
    }

    Folder folder_;
};

TEST_F(Merge, OfAllPartsIsTheRunOfOneProcess) {
    const Outcome whole =
        run({"sweep", "--plan", "tiny.json", "--store", "whole.db", "--json", "--fom"}, folder_);
    ASSERT_EQ(whole.exit_code, 0) << whole.err;
    EXPECT_THAT(whole.out, AllOf(ContainsRegex("\nFOM cells_verified = [1-9][0-9]* cells\n"),
                                 HasSubstr("\nFOM cells_failed = 0 cells\n"),
                                 HasSubstr("\nFOM answers_wrong = 0 queries\n"),
                                 ContainsRegex("\nFOM time_ratio.gjk.lean_f32 = [0-9.]+ 1\n")));
    std::size_t cells = 0, rows = 0;
    for (const char* index : {"0", "1", "2"}) {
        const Outcome part =
            shard(std::string(index) + "/3", std::string(index) + ".db", {"--costs", "whole.db"});
        ASSERT_EQ(part.exit_code, 0) << part.err;
        const json summary = json::parse(part.out);
        EXPECT_TRUE(summary["report"].is_null());
        cells += summary["cells"].get<std::size_t>();
        rows += summary.value("stability_rows", std::size_t{0});
    }
    const json single = json::parse(lines_of(whole.out).front());
    EXPECT_EQ(cells, single["cells"]);
    EXPECT_EQ(rows, single["stability_rows"]);
    const Outcome merged = run({"merge", "2.db", "0.db", "1.db", "--out", "all.db", "--json"}, folder_);
    ASSERT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_EQ(json::parse(merged.out)["cells"], cells + rows);
    const Figures figures = deterministic_figures_in(folder_ / "all.db");
    EXPECT_GT(figures.size(), 500U);
    EXPECT_EQ(figures, deterministic_figures_in(folder_ / "whole.db"));
    EXPECT_EQ(run({"report", "all.db", "--out", "pages"}, folder_).exit_code, 0);
}

TEST_F(Merge, NamesWhatIsMissingAndWhatWasStopped) {
    const Outcome first = shard("0/2", "0.db");
    ASSERT_EQ(first.exit_code, 0) << first.err;
    const Outcome merged = run({"merge", "0.db", "--out", "all.db"}, folder_);
    EXPECT_EQ(merged.exit_code, 1);
    EXPECT_THAT(merged.err, HasSubstr("shard 1/2 is missing"));
    Process process(program_path, {"sweep", "--plan", "tiny.json", "--shard", "1/2", "--store", "1.db"},
                    folder_);
    while (rounds_in(folder_ / "1.db").empty() && !process.has_ended())
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    process.send(SIGKILL);
    ASSERT_EQ(process.wait().signal, SIGKILL) << "it was over before it could be ended";
    const Outcome stopped = run({"merge", "0.db", "1.db", "--out", "all.db"}, folder_);
    EXPECT_EQ(stopped.exit_code, 1);
    EXPECT_THAT(stopped.err, HasSubstr("shard 1/2 was stopped before its end"));
    ASSERT_EQ(shard("1/2", "1.db").exit_code, 0);
    EXPECT_EQ(run({"merge", "0.db", "1.db", "--out", "all.db"}, folder_).exit_code, 0);
    EXPECT_EQ(run({"merge", "0.db", "--out", "0.db"}, folder_).exit_code, 2) << "a part is not written over";
}

TEST_F(Merge, RefusesOtherSeedsUnlessTold) {
    ASSERT_EQ(shard("0/2", "0.db").exit_code, 0);
    ASSERT_EQ(shard("1/2", "1.db", {"--seed", "2", "--stability", "0"}).exit_code, 0);
    const Outcome refused = run({"merge", "0.db", "1.db", "--out", "all.db"}, folder_);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(lines_of(refused.err).size(), 1U);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("several seeds"), HasSubstr("--mixed")));
    EXPECT_EQ(run({"merge", "0.db", "1.db", "--out", "all.db", "--mixed"}, folder_).exit_code, 0);
}

TEST_F(Merge, HardFamiliesAreDealtToo) {
    const Arguments stability = {"stability", "--layouts", "aos_f64", "--count", "2", "--json"};
    std::size_t rows = 0;
    for (const std::string index : {"0", "1"}) {
        const Outcome outcome =
            run(with(stability, {"--shard", index + "/2", "--store", index + ".db"}), folder_);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        rows += json::parse(outcome.out)["rows"].get<std::size_t>();
    }
    ASSERT_EQ(run({"merge", "0.db", "1.db", "--out", "all.db"}, folder_).exit_code, 0);
    EXPECT_EQ(json::parse(run(with(stability, {"--store", "whole.db"}), folder_).out)["rows"], rows);
    EXPECT_EQ(deterministic_figures_in(folder_ / "all.db"), deterministic_figures_in(folder_ / "whole.db"));
}

}  // namespace
}  // namespace edgewise::cli_test
