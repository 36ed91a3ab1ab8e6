// SPDX-License-Identifier: MIT
//
// `edgewise bench scaling`: a row for each number of threads, the same in JSON, and one line where it is
// asked for what cannot be measured or answers are wrong.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli_paths.hpp"
#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

const Arguments short_scaling = {"bench",      "scaling",   "--shape", "cube8",    "--parameter",
                                 "bodies=100", "--queries", "500",     "--rounds", "2",
                                 "--checked",  "10",        "--table", "aos_f64"};

void expect_numbers(const Json& way, double threads) {
    EXPECT_GT(way["queries_per_second"].get<double>(), 0);
    EXPECT_NEAR(way["efficiency"].get<double>() * threads, way["speed_up"].get<double>(), 1e-9);
}

TEST(Scaling, HasARowForOneThreadAndForAllCores) {
    const Folder folder;
    for (const char* algorithm : {"vclip", "gjk"}) {
        const Outcome outcome = run(with(short_scaling, {"--json", "--algorithm", algorithm}), folder);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        const Json found = Json::parse(outcome.out);
        EXPECT_EQ(found["algorithm"], algorithm);
        EXPECT_EQ(found["queries"], 500);
        EXPECT_EQ(found["checked"], 10);
        EXPECT_EQ(found["frames"], 6) << "of 99 pairs";
        EXPECT_TRUE(found["wrong"].is_null());
        EXPECT_GT(found["table_bytes"], 100 * 8 * 24);
        const Json& rows = found["rows"];
        EXPECT_EQ(rows.front()["threads"], 1);
        EXPECT_EQ(rows.back()["threads"], found["cores"]);
        for (const Json& row : rows) {
            for (const char* way : {"shared", "apart"}) expect_numbers(row[way], row["threads"]);
            EXPECT_GT(row["contention"], 0);
        }
    }
}

/// Tables of threads are solved as shared ones are.
TEST(Scaling, PrintsATable) {
    const Folder folder;
    const Outcome outcome = run(
        with(short_scaling, {"--threads", "1", "--algorithm", "gjk", "--sub-distance", "johnson"}), folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(lines_of(outcome.out).size(), 7U) << outcome.out;
    for (const char* word : {"aos_f64", "pressure", "speed-up", "efficiency", "contention", "2 rounds"})
        EXPECT_THAT(outcome.out, HasSubstr(word));
}

/// Its bodies are not where its table says.
TEST(Scaling, OfAWrongLayoutIsNotMeasured) {
    const Folder folder;
    const Outcome outcome = Process(crooked_program_path,
                                    {"bench", "scaling", "--table", "crooked_f64", "--algorithm", "gjk",
                                     "--shape", "cube8", "--queries", "300", "--json"},
                                    folder)
                                .wait();
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    const Json found = Json::parse(outcome.out);
    EXPECT_TRUE(found["wrong"].is_string()) << found;
    EXPECT_TRUE(found["rows"].empty());
}

}  // namespace
}  // namespace edgewise::cli_test
