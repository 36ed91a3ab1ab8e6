// SPDX-License-Identifier: MIT
//
// A campaign by GNU parallel ends complete and equals the single run although workers and merges are killed.
#include <csignal>
#include <filesystem>

#include "campaign_run.hpp"

namespace edgewise::cli_test {
namespace {

using Parallel = CampaignRun;

TEST_F(Parallel, EndsCompleteThoughAWorkerIsKilled) {
    const Arguments command = script("parallel", {"--shards", "8", "--jobs", "2"});
    Process campaign("/bin/sh", command, folder_);
    EXPECT_TRUE(kill_a_worker(campaign)) << "there was no worker to kill";
    const Outcome outcome = campaign.wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_complete();
    kill_merges();
    expect_complete();
}

/// The whole campaign is killed; the same command does the remaining parts.
TEST_F(Parallel, GoesOnAfterItWasKilledItself) {
    const Arguments command = script("parallel", {"--shards", "3", "--jobs", "1"});
    {
        Process campaign("/bin/sh", command, folder_);
        EXPECT_TRUE(kill_a_worker(campaign));
        campaign.send(SIGKILL);
        static_cast<void>(campaign.wait());
        while (const auto left = find_process("--shard")) kill(*left, SIGKILL);
    }
    EXPECT_EQ(Process("/bin/sh", command, folder_).wait().exit_code, 0);
    expect_complete();
}

}  // namespace
}  // namespace edgewise::cli_test
