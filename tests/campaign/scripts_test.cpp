// SPDX-License-Identifier: MIT
//
// The scripts for the schedulers: their messages, and that --dry-run does nothing.
#include "campaign_run.hpp"

namespace edgewise::cli_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Scripts : public CampaignRun, public testing::WithParamInterface<const char*> {};

TEST_P(Scripts, SayWhatTheyWouldDoAndDoNothing) {
    const Outcome outcome =
        Process("/bin/sh", script(GetParam(), {"--shards", "3", "--gate", "gate.json", "--dry-run"}), folder_)
            .wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out + outcome.err,
                AllOf(HasSubstr("sweep --shard"), HasSubstr("parts of it"), HasSubstr("merge"),
                      HasSubstr("report"), HasSubstr("bench gate"), HasSubstr("tiny.json")));
    EXPECT_FALSE(std::filesystem::exists(parts_));
}

TEST_P(Scripts, RefuseWhatTheyDoNotKnow) {
    for (const Arguments& bad : {Arguments{"--nope"}, {"--shards"}, {"--shards", "0"}, {"--shards", "-1"}}) {
        const Outcome outcome = Process("/bin/sh", script(GetParam(), bad), folder_).wait();
        EXPECT_EQ(outcome.exit_code, 2) << bad.back();
        EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    }
    const Outcome help = Process("/bin/sh", script(GetParam(), {"--help"}), folder_).wait();
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.out, AllOf(HasSubstr("--dry-run"), HasSubstr("--shards")));
}

INSTANTIATE_TEST_SUITE_P(Campaign, Scripts, testing::Values("parallel", "slurm"),
                         [](const auto& engine) { return std::string(engine.param); });

}  // namespace
}  // namespace edgewise::cli_test
