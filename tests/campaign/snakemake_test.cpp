// SPDX-License-Identifier: MIT
//
// A campaign by Snakemake ends complete although a worker is killed.
#include "campaign_paths.hpp"
#include "campaign_run.hpp"

namespace edgewise::cli_test {
namespace {

using testing::HasSubstr;

class Snakemake : public CampaignRun {
  protected:
    [[nodiscard]] Arguments command(const Arguments& options) const {
        Arguments words = {"--snakefile", std::string(source_folder) + "/layouts/campaign/Snakefile",
                           "--cores", "1", "--nocolor"};
        words.insert(words.end(), options.begin(), options.end());
        words.insert(words.end(), {"--config", "shards=3", std::string("program=") + program,
                                   "folder=" + parts_, "sweep=--plan tiny.json"});
        return words;
    }
};

TEST_F(Snakemake, SaysWhatItWouldDo) {
    const Outcome outcome = Process(snakemake, command({"--dry-run", "--printshellcmds"}), folder_).wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* step : {"sweep --shard 0/3", "sweep --shard 2/3", "merge", "report"})
        EXPECT_THAT(outcome.out + outcome.err, HasSubstr(step));
    EXPECT_FALSE(std::filesystem::exists(parts_));
}

TEST_F(Snakemake, EndsCompleteThoughAWorkerIsKilled) {
    Process campaign(snakemake, command({}), folder_);
    EXPECT_TRUE(kill_a_worker(campaign)) << "there was no worker to kill";
    const Outcome outcome = campaign.wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_complete();
}

}  // namespace
}  // namespace edgewise::cli_test
