// SPDX-License-Identifier: MIT
#include "campaign_run.hpp"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

#include "campaign_paths.hpp"
#include "deterministic_figures.hpp"
#include "tiny_plan.hpp"

namespace edgewise::cli_test {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

CampaignRun::CampaignRun() : parts_((folder_ / "parts of it").string()) {
    folder_.write("tiny.json", tiny_plan);
}

Arguments CampaignRun::script(const std::string& name, const Arguments& options) const {
    Arguments arguments = {std::string(source_folder) + "/layouts/campaign/" + name, "--program", program,
                           "--folder", parts_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    arguments.insert(arguments.end(), {"--", "--plan", (folder_ / "tiny.json").string()});
    return arguments;
}

std::optional<pid_t> CampaignRun::find_process(const std::string& with) const {
    std::error_code error;
    for (fs::directory_iterator at("/proc", error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        const std::string line = text_of(at->path() / "cmdline");
        if (line.starts_with(program) && line.find(parts_) != std::string::npos &&
            line.find(with) != std::string::npos)
            return std::stoi(name);
    }
    return std::nullopt;
}

bool CampaignRun::kill_a_worker(Process& campaign) {
    for (int i = 0; i < 30'000 && !campaign.has_ended(); ++i) {
        std::this_thread::sleep_for(milliseconds(2));
        const auto worker = find_process("--shard");
        if (!worker || !fs::exists(parts_ + "/shards")) continue;
        for (const auto& entry : fs::directory_iterator(parts_ + "/shards")) {
            if (entry.path().extension() != ".db" || rounds_in(entry.path()).empty()) continue;
            return kill(*worker, SIGKILL) == 0;
        }
    }
    return false;
}

void CampaignRun::kill_merges() {
    Arguments merge = {"merge", "--out", parts_ + "/edgewise.db"};
    for (const auto& entry : fs::directory_iterator(parts_ + "/shards"))
        if (entry.path().extension() == ".db") merge.push_back(entry.path().string());
    const auto before = deterministic_figures_in(parts_ + "/edgewise.db");
    int killed = 0;
    for (int trial = 0; trial < 12; ++trial) {
        Process process(program, merge, folder_);
        std::this_thread::sleep_for(milliseconds(trial * 4));
        process.send(SIGKILL);
        killed += process.wait().signal == SIGKILL;
        EXPECT_EQ(deterministic_figures_in(parts_ + "/edgewise.db"), before);
    }
    std::printf("merges: %d of 12 killed\n", killed);
    EXPECT_GT(killed, 0);
    EXPECT_EQ(Process(program, merge, folder_).wait().exit_code, 0);
}

void CampaignRun::expect_complete() {
    const Outcome single =
        Process(program, {"sweep", "--plan", "tiny.json", "--store", "single.db"}, folder_).wait();
    ASSERT_EQ(single.exit_code, 0) << single.err;
    const Figures figures = deterministic_figures_in(folder_ / "single.db");
    EXPECT_GT(figures.size(), 500U);
    EXPECT_EQ(deterministic_figures_in(parts_ + "/edgewise.db"), figures);
    EXPECT_TRUE(fs::exists(parts_ + "/index.html")) << "the report";
}

}  // namespace edgewise::cli_test
