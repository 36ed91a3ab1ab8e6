// SPDX-License-Identifier: MIT
//
// A campaign in a folder of its own, its workers, and the single run that it must equal.
#pragma once

#include <gmock/gmock.h>

#include <optional>
#include <string>

#include "program.hpp"

namespace edgewise::cli_test {

class CampaignRun : public testing::Test {
  protected:
    CampaignRun();

    /// layouts/campaign/NAME with these options, on the tiny plan.
    [[nodiscard]] Arguments script(const std::string& name, const Arguments& options) const;

    /// A process in this campaign's folder with this text in its command line; no value if there is none.
    [[nodiscard]] std::optional<pid_t> find_process(const std::string& with) const;
    /// Waits until a worker has stored a round and ends it by SIGKILL; false when none came.
    bool kill_a_worker(Process& campaign);
    /// Ends a merge of the parts by SIGKILL at several moments; the store must stay whole.
    void kill_merges();

    void expect_complete();

    Folder folder_;
    std::string parts_;  ///< the campaign's folder
};

}  // namespace edgewise::cli_test
