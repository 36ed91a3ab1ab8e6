// SPDX-License-Identifier: MIT
//
// kill -9 at any moment: every round whose put_round returned is in the store, whole, and nothing is damaged.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <utility>
#include <vector>

#include "edgewise/store/store.hpp"
#include "store_fixture.hpp"

namespace edgewise::store {
namespace {

/// Writes rounds for ever, each acknowledged through the pipe once put_round has returned.
[[noreturn]] void write_rounds(const std::string& path, int first, int pipe_end) {
    Store store(path);
    for (int number = first;; ++number) {
        const std::vector<std::pair<std::string, measure::Round>> rounds = {{"cell-1", sample_round(number)},
                                                                            {"cell-2", sample_round(number)}};
        store.put_round("build-1", rounds);
        if (write(pipe_end, &number, sizeof number) != sizeof number) _exit(1);
    }
}

/// Kills a writer after about `enough` rounds; the last round that it acknowledged.
int kill_writer(const std::string& path, int first, int enough) {
    int ends[2];
    if (pipe(ends) != 0) return -1;
    const pid_t child = fork();
    if (child < 0) return -1;
    if (child == 0) {
        close(ends[0]);
        write_rounds(path, first, ends[1]);
    }
    close(ends[1]);
    int last = -1;
    int number = 0;
    while (read(ends[0], &number, sizeof number) == sizeof number) {
        last = number;
        if (last == first + enough)
            kill(child, SIGKILL);  // and read on: what it still acknowledged counts too
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    return last;
}

TEST_F(StoreTest, KillLosesNoAcknowledgedRound) {
    int first = 0;
    int unacknowledged = 0;
    for (const int enough : {0, 1, 7, 40, 133, 250}) {
        const int last = kill_writer(path_, first, enough);
        ASSERT_GE(last, first + enough);
        const Store store(path_);
        const auto rounds = store.rounds("build-1", "cell-1");
        // Nothing acknowledged is missing; at most the one round whose acknowledgement the kill prevented is
        // more.
        ASSERT_GE(static_cast<int>(rounds.size()), last + 1);
        ASSERT_LE(static_cast<int>(rounds.size()), last + 2);
        unacknowledged += static_cast<int>(rounds.size()) - (last + 1);
        for (std::size_t i = 0; i < rounds.size(); ++i) {
            ASSERT_TRUE(equal(rounds[i], sample_round(static_cast<int>(i)))) << i;
        }
        // A round is whole or not there: both cells have the same ones.
        EXPECT_EQ(store.rounds_done("build-1", "cell-1"), store.rounds_done("build-1", "cell-2"));
        first = static_cast<int>(rounds.size());
    }
    std::printf("rounds kept: %d, of these %d committed but not yet acknowledged at a kill\n", first,
                unacknowledged);
}

}  // namespace
}  // namespace edgewise::store
