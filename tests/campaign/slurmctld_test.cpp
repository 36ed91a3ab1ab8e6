// SPDX-License-Identifier: MIT
//
// A campaign as a Slurm job array on a cluster of this machine's loopback: a worker and a node's daemon are
// killed, and the same command, repeated, completes the campaign.
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "campaign_paths.hpp"
#include "campaign_run.hpp"

namespace edgewise::cli_test {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

class Slurm : public CampaignRun {
  protected:
    void SetUp() override {
        const Outcome up = loop("up");
        ASSERT_EQ(up.exit_code, 0) << up.err;
        configuration_ = lines_of(up.out).back();
    }
    void TearDown() override { static_cast<void>(loop("down")); }

    [[nodiscard]] Outcome loop(const std::string& what) const {
        return Process("/bin/sh",
                       {std::string(source_folder) + "/tests/campaign/slurm_loop.sh", cluster(), what},
                       folder_)
            .wait();
    }
    [[nodiscard]] std::string cluster() const { return (folder_ / "cluster").string(); }
    [[nodiscard]] pid_t daemon(const std::string& name) const {
        return std::stoi(text_of(cluster() + "/" + name + ".pid"));
    }

    /// Runs a client with the cluster's configuration, for at most 60 seconds.
    [[nodiscard]] Outcome client(const Arguments& words) const {
        Arguments all = {configuration_, "timeout", "60"};
        all.insert(all.end(), words.begin(), words.end());
        return Process("/usr/bin/env", all, folder_).wait();
    }
    [[nodiscard]] Outcome submit() const {
        Arguments all = {"/bin/sh"};
        const Arguments words = script("slurm", {"--shards", "8", "--sbatch", "--exclusive"});
        all.insert(all.end(), words.begin(), words.end());
        return client(all);
    }
    /// Waits until no job is left that can run; returns false if that takes too long.
    [[nodiscard]] bool wait_for_jobs() const {
        for (int i = 0; i < 600; ++i) {
            if (client({"squeue", "-h"}).out.empty()) return true;
            release_held();
            std::this_thread::sleep_for(500ms);
        }
        return false;
    }

    /// Slurm holds a job that it requeued after its node was lost; this releases it.
    void release_held() const {
        for (const std::string& line : lines_of(client({"squeue", "-h", "-t", "PD", "-o", "%i %r"}).out)) {
            if (line.find("eld") != std::string::npos)
                static_cast<void>(client({"scontrol", "release", line.substr(0, line.find(' '))}));
        }
    }

    std::string configuration_;
};

TEST_F(Slurm, ArrayEndsCompleteThoughAWorkerAndANodeAreKilled) {
    ASSERT_EQ(submit().exit_code, 0);
    bool killed = false;
    for (int i = 0; i < 20'000 && !killed; ++i) {
        std::this_thread::sleep_for(5ms);
        const auto worker = find_process("--shard");
        killed = worker && kill(*worker, SIGKILL) == 0;
    }
    EXPECT_TRUE(killed) << "there was no worker to kill";
    EXPECT_EQ(kill(daemon("n2"), SIGKILL), 0);
    std::this_thread::sleep_for(1s);
    // The node comes back, as a machine would; its job is requeued or lost.
    EXPECT_EQ(client({"slurmd", "-N", "n2"}).exit_code, 0);
    EXPECT_TRUE(wait_for_jobs()) << client({"squeue"}).out;
    std::printf("after the kills: %s\n", text_of(parts_ + "/logs/merge.log").c_str());
    for (int again = 0;
         again < 3 && text_of(parts_ + "/logs/merge.log").find("8 stores") == std::string::npos; ++again) {
        ASSERT_EQ(submit().exit_code, 0);
        EXPECT_TRUE(wait_for_jobs());
    }
    ASSERT_EQ(submit().exit_code, 0) << "once more, with everything there";
    EXPECT_TRUE(wait_for_jobs());
    expect_complete();
    kill_merges();
    expect_complete();
}

}  // namespace
}  // namespace edgewise::cli_test
