// SPDX-License-Identifier: MIT
//
// Every option of every command that takes a real number takes decimal, finite ones alone. The options are
// those that --help shows with a type of NUMBER; no option may have a type of CLI11's own, which would take
// nan, inf and 0x10.
#include <gmock/gmock.h>

#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using testing::HasSubstr;

const std::vector<std::string> hostile = {"nan",    "-nan",  "NaN",   "inf", "-inf", "infinity",
                                          "0x10",   "0x1p3", " 5",    "5 ",  "+5",   "1e999",
                                          "-1e999", "5x",    "1_000", "1e",  "--5",  "many"};

/// How the type's text has a number in it: "NUMBER" is the number, "NAME=NUMBER" a name before it.
std::string with_number(const std::string& type, const std::string& number) {
    if (type == "NUMBERS") return "1," + number + ",1";
    return type.substr(0, type.find("NUMBER")) + number;
}

TEST(RealOptions, AreReadByOneReader) {
    const Folder folder;
    int options = 0;
    for (const std::string& command : listed_commands(folder)) {
        for (const ListedOption& option : listed_options(command, folder)) {
            for (const char* const raw : {"FLOAT", "INT", "UINT"})
                EXPECT_FALSE(option.type.starts_with(raw)) << command << " " << option.name;
            if (option.type.find("NUMBER") == option.type.npos) continue;
            ++options;
            const auto given = [&](const std::string& number) {
                return run(
                    called("--parse-only " + command, {option.name + "=" + with_number(option.type, number)}),
                    folder);
            };
            EXPECT_THAT(given("0.5").err + given("7").err,
                        testing::Not(testing::AllOf(HasSubstr("'0.5' wants"), HasSubstr("'7' wants"))))
                << command << option.name << " takes no number at all";
            for (const std::string& number : hostile) {
                if (option.type == "NUMBERS" && number.find(' ') != number.npos) continue;
                const Outcome outcome = given(number);
                EXPECT_EQ(outcome.exit_code, 2) << command << option.name << number;
                EXPECT_EQ(outcome.out, "");
                EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
                EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr(option.name), HasSubstr(number)));
            }
        }
    }
    EXPECT_GE(options, 30) << "few options were found: is --help read right?";
}

TEST(RealOptions, SayUnitAndRange) {
    const Folder folder;
    const auto complaint = [&](const Arguments& words) { return run(words, folder).err; };
    EXPECT_THAT(complaint({"advise", "--time", "nan"}),
                HasSubstr("--time 'nan' wants a decimal number of seconds, 5 to 3600"));
    EXPECT_THAT(complaint({"query", "x", "--gap-tolerance", "1"}),
                HasSubstr("wants a decimal number, 0 to 0.999"));
    EXPECT_THAT(complaint({"advise", "budget", "--tolerance", "0"}),
                HasSubstr("wants a decimal number, above 0"));
    EXPECT_THAT(complaint({"paging", "--limits", "4,nan"}),
                HasSubstr("--limits 'nan' wants a decimal number of MiB"));
    EXPECT_THAT(complaint({"query", "x", "--contact-tolerance", "-1"}), HasSubstr("0 or more"));
}

}  // namespace
}  // namespace edgewise::cli_test
