// SPDX-License-Identifier: MIT
//
// A campaign by GNU parallel with killed workers and merges: it ends complete, and equals the single run.
#include <csignal>
#include <filesystem>

#include "campaign_run.hpp"

namespace edgewise::cli_test {
namespace {

using Parallel = CampaignRun;

TEST_F(Parallel, EndsCompleteThoughAWorkerIsKilled) {
    const Arguments command = script("parallel", {"--shards", "8", "--jobs", "2"});
    Process campaign("/bin/sh", command, folder_);
    EXPECT_TRUE(kill_a_worker(campaign)) << "no worker was there to be killed";
    const Outcome outcome = campaign.wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_complete();
    kill_merges();
    expect_complete();
}

/// The whole of it is killed; the same command does what is left.
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
