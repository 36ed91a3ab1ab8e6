// SPDX-License-Identifier: MIT
//
// A baseline's file: what is written is read again, and what is broken gets one line.
#include "edgewise/studies/gate/file.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "gate_records.hpp"

namespace edgewise::studies {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

TEST(GateFile, IsReadAsItWasWritten) {
    GateRecord record = drawn_record(3, 0, 1);
    record.git_revision = "r";
    record.slack = 0.25;
    const auto read = parse_gate("b.json", gate_json(record).dump());
    ASSERT_TRUE(read) << read.error;
    EXPECT_EQ(gate_json(*read), gate_json(record));
    ASSERT_EQ(read->entries.size(), record.entries.size());
    for (std::size_t i = 0; i < record.entries.size(); ++i) {
        EXPECT_EQ(read->entries[i].name(), record.entries[i].name());
        EXPECT_EQ(read->entries[i].over, record.entries[i].over);
        EXPECT_EQ(read->entries[i].ratio.low, record.entries[i].ratio.low);
    }
    EXPECT_EQ(read->slack, 0.25);
    EXPECT_EQ(read->queries, 1000u);
}

void expect_gate_line(const std::string& text, const std::string& mentioned) {
    const auto read = parse_gate("b.json", text);
    ASSERT_FALSE(read) << text;
    EXPECT_THAT(read.error, HasSubstr("b.json"));
    EXPECT_THAT(read.error, HasSubstr(mentioned));
    EXPECT_THAT(read.error, HasSubstr("--write")) << "what to do";
    EXPECT_THAT(read.error, Not(HasSubstr("\n")));
}

TEST(GateFile, WhatIsNoJsonIsOneLine) {
    const std::string text = gate_json(drawn_record(3, 0, 1)).dump();
    for (const std::size_t kept : {std::size_t{0}, std::size_t{1}, text.size() / 2, text.size() - 1})
        expect_gate_line(text.substr(0, kept), "column");
    expect_gate_line("[]", "object");
}

TEST(GateFile, AWrongMemberIsNamed) {
    const json right = gate_json(drawn_record(3, 0, 1));
    const std::vector<std::pair<std::string, std::function<void(json&)>>> faults = {
        {"gate", [](json& of) { of["gate"] = 2; }},
        {"machine", [](json& of) { of.erase("machine"); }},
        {"build wants", [](json& of) { of.erase("build"); }},
        {"build.flags", [](json& of) { of["build"]["flags"] = 1; }},
        {"rounds", [](json& of) { of["rounds"] = 2.5; }},
        {"queries", [](json& of) { of["queries"] = -1; }},
        {"slack", [](json& of) { of["slack"] = -0.1; }},
        {"entries wants", [](json& of) { of["entries"] = 3; }},
        {"entries[1].ratio", [](json& of) { of["entries"][1]["ratio"] = 0; }},
        {"entries[1].low", [](json& of) { of["entries"][1]["low"] = "x"; }},
        {"entries[0].over", [](json& of) { of["entries"][0]["over"] = "all"; }},
        {"again", [](json& of) { of["entries"][1] = of["entries"][0]; }},
        {"entries[2] wants", [](json& of) { of["entries"][2] = 7; }},
    };
    for (const auto& [mentioned, spoil] : faults) {
        json spoilt = right;
        spoil(spoilt);
        expect_gate_line(spoilt.dump(), mentioned);
    }
}

}  // namespace
}  // namespace edgewise::studies
