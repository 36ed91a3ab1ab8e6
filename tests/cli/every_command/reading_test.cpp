// SPDX-License-Identifier: MIT
//
// Every command that reads a JSON file refuses a member that is there twice, and an unknown member.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

struct Reader {
    std::string what;
    Arguments reading;       ///< of x.json
    Arguments writing = {};  ///< with which the program makes x.json, or prints it
    std::string text = {};   ///< of x.json where the program makes none
};

const Arguments of_fields = {"fields",   "--shape", "cube8",     "--queries", "50",
                             "--rounds", "9",       "--checked", "5"};

const Arguments of_small_sweep = {"--layouts", "aos_f64", "--queries", "50",   "--checked",  "10",
                                  "--rounds",  "2",       "--store",   "s.db", "--no-report"};
const Arguments of_gate = {"bench",     "gate", "x.json",    "--rounds", "9",
                           "--queries", "50",   "--layouts", "aos_f64"};
const Arguments of_campaign = {"campaign", "--pairs",   "50",      "--families", "random", "--shapes",
                               "cube8",    "--layouts", "aos_f64", "--state",    "x.json"};

const std::vector<Reader> readers = {
    {"scene",
     with({"sweep", "--scenes", "x.json"}, of_small_sweep),
     {},
     R"({"scene": "cold", "shapes": ["cube8"], "queries": 50})"},
    {"plan",
     with({"sweep", "--plan", "x.json", "--scenes", "cold", "--shapes", "cube8"}, of_small_sweep),
     {},
     R"({"rounds": 2, "seed": 3})"},
    {"machine",
     {"caches", "--shape", "cube8", "--queries", "20", "--machines", "x.json"},
     {},
     R"({"line_bytes": 64, "levels": [{"name": "L1D", "bytes": "32K", "ways": 8}]})"},
    {"lock", {"lock", "--check", "x.json"}, {"lock", "--shape", "cube8", "--queries", "10"}},
    {"baseline", of_gate, with(of_gate, {"--write"})},
    {"state", of_campaign, of_campaign},
    {"record", {"compare", "x.json"}, {"export", "s.db", "--machine-record"}},
    {"groups", with(of_fields, {"--groups", "x.json"}), with(of_fields, {"--write", "x.json"})},
};

/// A text that the reader takes.
std::string right_text(const Reader& reader, const Folder& folder) {
    if (reader.writing.empty()) return reader.text;
    std::filesystem::remove(folder / "x.json");
    const Outcome outcome = run(reader.writing, folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return std::filesystem::exists(folder / "x.json") ? text_of(folder / "x.json") : outcome.out;
}

TEST(JsonFiles, HaveNoMemberTwiceAndNoneThatNobodyKnows) {
    const Folder folder;
    ASSERT_EQ(run(with({"sweep", "--scenes", "cold", "--shapes", "cube8"}, of_small_sweep), folder).exit_code,
              0);
    for (const Reader& reader : readers) {
        const std::string right = right_text(reader, folder);
        const auto reading = [&](const std::string& first_member) {
            folder.write("x.json", "{" + first_member + right.substr(right.find('{') + 1));
            return run(reader.reading, folder);
        };
        const Outcome taken = reading("");
        EXPECT_NE(taken.exit_code, 2) << reader.what << ": " << taken.err;
        const std::string name = json::parse(right).begin().key();
        const std::string value = json::parse(right).begin()->dump();
        for (const auto& [member, complaint] : std::vector<std::pair<std::string, std::string>>{
                 {"\"" + name + "\":" + value + ",", name + " is given twice"},
                 {"\"" + name + "x\":" + value + ",", "'" + name + "x' is not a member of"}}) {
            const Outcome refused = reading(member);
            EXPECT_EQ(refused.exit_code, 2) << reader.what;
            EXPECT_EQ(refused.out, "") << reader.what;
            EXPECT_EQ(lines_of(refused.err).size(), 1U) << refused.err;
            EXPECT_THAT(refused.err,
                        testing::AllOf(testing::AnyOf(HasSubstr("x.json: "), HasSubstr("scene file x: ")),
                                       HasSubstr(complaint)))
                << reader.what;
        }
    }
}

// Every option of every command that takes a number reads it by the project's reader, whose own tests are in
// tests/unit/input/count_test.cpp. The options are those that --help shows with a type of NUMBER or COUNT; no
// option may have a type of CLI11's own, which would take nan, inf and 0x10.

const std::vector<std::string> hostile = {"nan", "0x10", "5x"};

/// How the type's text has a number in it: "NUMBER" is the number, "NAME=NUMBER" a name before it.
std::string with_number(const std::string& type, const std::string& number) {
    if (type == "NUMBERS") return "1," + number + ",1";
    return type == "COUNT" ? number : type.substr(0, type.find("NUMBER")) + number;
}

TEST(NumberOptions, AreReadByOneReader) {
    const Folder folder;
    int options = 0, counts = 0;
    for (const std::string& command : listed_commands(folder)) {
        for (const ListedOption& option : listed_options(command, folder)) {
            for (const char* const raw : {"FLOAT", "INT", "UINT"})
                EXPECT_FALSE(option.type.starts_with(raw)) << command << " " << option.name;
            const bool is_count = option.type == "COUNT";
            if (!is_count && option.type.find("NUMBER") == option.type.npos) continue;
            ++(is_count ? counts : options);
            const auto given = [&](const std::string& number) {
                return run(
                    called("--parse-only " + command, {option.name + "=" + with_number(option.type, number)}),
                    folder);
            };
            if (!is_count) {
                EXPECT_THAT(given("0.5").err + given("7").err,
                            testing::Not(testing::AllOf(HasSubstr("'0.5' wants"), HasSubstr("'7' wants"))))
                    << command << option.name << " takes no number at all";
            }
            for (const std::string& number : hostile) {
                const Outcome outcome = given(number);
                EXPECT_EQ(outcome.exit_code, 2) << command << option.name << number;
                EXPECT_EQ(outcome.out, "");
                EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
                EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr(option.name), HasSubstr(number)));
            }
        }
    }
    EXPECT_GE(options, 30) << "few options were found: is --help read right?";
    EXPECT_GE(counts, 15);
}

}  // namespace
}  // namespace edgewise::cli_test
