// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <gtest/gtest.h>

namespace edgewise::cli_test {

namespace {

constexpr const char* a_case =
    R"({"id":"1","a":{"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]},"b":{"vertices":[[3,0,0],[4,0,0],[3,1,0],[3,0,1]]}})"
    "\n";

/// Words that let each command print something within seconds, in the folder of fill().
const std::map<std::string, Arguments> printing_arguments = {
    {"advise", {"--store", "s.db"}},
    {"bench model", {"--shape", "cube8", "--queries", "20", "--repetitions", "1"}},
    {"advise budget", {"--shape", "sphere38"}},
    {"bench gate", {"b.json", "--write", "--rounds", "9", "--queries", "200", "--layouts", "aos_f64"}},
    {"bytes", {"--layouts", "aos_f64"}},
    {"caches", {"--shape", "cube8", "--queries", "20"}},
    {"bench calibrate", {"--loads", "1000", "--times", "0.01"}},
    {"campaign", {"--pairs", "50", "--families", "random", "--shapes", "cube8", "--layouts", "aos_f64"}},
    {"report claims", {"s.db"}},
    {"compare", {"r.json"}},
    {"bench crosscheck", {"--shape", "cube8", "--queries", "20"}},
    {"draw layout", {"aos_f64", "--shape", "tetra4"}},
    {"bench effort", {"--shape", "cube8", "--queries", "20", "--layouts", "aos_f64", "--checked", "5"}},
    {"export", {"s.db"}},
    {"fields", {"--shape", "cube8", "--queries", "50", "--rounds", "9", "--checked", "5"}},
    {"draw heat", {"--shape", "cube8", "--queries", "20"}},
    {"judge", {"c.jsonl", "--layouts", "aos_f64"}},
    {"list", {"layouts"}},
    {"lock", {"--shape", "cube8", "--queries", "10"}},
    {"machine", {}},
    {"merge", {"s.db", "--out", "m.db"}},
    {"paging",
     {"--bodies", "4", "--steps", "1", "--shape", "cube8", "--layouts", "aos_f64", "--limits", "0"}},
    {"query", {"c.jsonl"}},
    {"record", {"bullet-stack", "--seconds", "0.1", "--out", "m.jsonl"}},
    {"report", {"s.db", "--out", "report"}},
    {"bench scaling",
     {"--shape", "cube8", "--queries", "50", "--rounds", "1", "--threads", "1", "--checked", "5"}},
    {"stability",
     {"--count", "1", "--layouts", "aos_f64", "--families", "real_hulls_at_gaps", "--shape", "cube8",
      "--store", "t.db"}},
    {"sweep",
     {"--scenes", "cold", "--shapes", "cube8", "--layouts", "aos_f64", "--queries", "50", "--checked", "10",
      "--rounds", "2", "--store", "s.db", "--no-report"}},
    {"paging thrash",
     {"--layouts", "aos_f64", "--bodies", "8", "--memory", "1", "--fault-ns", "1000", "--steps", "12",
      "--realised", "0"}},
};

}  // namespace

void fill(const Folder& folder) {
    ASSERT_EQ(run({"sweep", "--scenes", "cold", "--shapes", "cube8", "--layouts", "aos_f64", "--queries",
                   "50", "--checked", "10", "--rounds", "2", "--store", "s.db", "--no-report"},
                  folder)
                  .exit_code,
              0);
    ASSERT_EQ(run({"export", "s.db", "--machine-record", "--out", "r.json"}, folder).exit_code, 0);
    folder.write("c.jsonl", a_case);
}

const std::map<std::string, Arguments>& printing() { return printing_arguments; }

}  // namespace edgewise::cli_test
