// SPDX-License-Identifier: MIT
//
// Files of groups, what is wrong with some, and when advice on fields held.
#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>

#include "edgewise/studies/fields/fields.hpp"

namespace edgewise::studies {
namespace {

using ::testing::HasSubstr;

std::string refusal_of(const std::string& text, const std::vector<RecordField>& fields) {
    const std::string file = testing::TempDir() + "groups.json";
    std::ofstream(file) << text;
    try {
        static_cast<void>(read_groups(file, fields));
    } catch (const std::invalid_argument& problem) {
        return problem.what();
    }
    return "";
}

TEST(GroupText, SaysWhatIsWrongWithAFile) {
    const std::vector<RecordField> fields = {{"a", "one", 4, 4}, {"b", "one", 8, 8}, {"c", "other", 4, 4}};
    EXPECT_EQ(refusal_of(R"({"groups": [["b", "a"], ["c"]]})", fields), "");
    EXPECT_THAT(refusal_of(R"({"groups": [["a"], ["c"]]})", fields), HasSubstr("field 'b' is in no group"));
    EXPECT_THAT(refusal_of(R"({"groups": [["a", "x"]]})", fields),
                HasSubstr("unknown field 'x'; known: a, b, c"));
    EXPECT_THAT(refusal_of(R"({"groups": [["a", "b"], ["a"], ["c"]]})", fields),
                HasSubstr("'a' is named twice"));
    EXPECT_THAT(refusal_of(R"({"groups": [["a", "c"], ["b"]]})", fields), HasSubstr("not one record"));
    EXPECT_THAT(refusal_of(R"({"groups": 3})", fields), HasSubstr("wanted:"));
}

FieldsAdvice timed(double advised, double spread) {
    FieldsAdvice advice;
    using Role = FieldsContender::Role;
    advice.contenders.resize(3);
    advice.contenders[0].role = Role::original;
    advice.contenders[1].role = Role::control;
    advice.contenders[2].role = Role::advised;
    for (int round = 0; round < 25; ++round) {
        const double wave = spread * (round % 5 - 2) / 2;
        advice.contenders[0].ns.push_back(100);
        advice.contenders[1].ns.push_back(100 * (1 - wave));
        advice.contenders[2].ns.push_back(100 * advised * (1 + wave));
    }
    return advice;
}

TEST(FieldsAdvice, HeldDidNotHoldOrNobodyKnows) {
    EXPECT_EQ(timed(0.9, 0.01).time_held(), Held::yes);
    EXPECT_EQ(timed(1.1, 0.01).time_held(), Held::no);
    EXPECT_EQ(timed(0.99, 0.2).time_held(), Held::within_noise);
    EXPECT_EQ(timed(1.01, 0.2).time_held(), Held::within_noise);
    FieldsAdvice advice = timed(1, 0);
    advice.contenders[0].cost.lines = 100;
    advice.predicted.lines = advice.contenders[2].cost.lines = 90;
    EXPECT_EQ(advice.lines_held(), Held::yes);
    advice.contenders[2].cost.lines = 91;
    EXPECT_EQ(advice.lines_held(), Held::no) << "not what was predicted";
    advice.predicted.lines = advice.contenders[2].cost.lines = 100;
    EXPECT_EQ(advice.lines_held(), Held::no) << "nothing saved";
}

}  // namespace
}  // namespace edgewise::studies
