// SPDX-License-Identifier: MIT
//
// Records of figures: a file says again what was written, files of earlier versions are read, each kind of
// difference has its outcome, and a file that is no record gets one line.
#include "edgewise/measure/record/record.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "../complaint.hpp"
#include "edgewise/measure/lock/lock_program.hpp"
#include "edgewise/measure/record/comparison.hpp"

namespace edgewise::measure {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RecordRow interval_row(std::string cell, double low, double value, double high) {
    return {std::move(cell), "time", value, low, high, true};
}

const FigureRecord lock = {"lock",
                           {{"points", "1000"}, {"tree", "k-d"}},
                           {},
                           {},
                           {{"", "bytes", 24000}, {"", "lines_per_query", 14.1}, {"", "knee_bytes", 0}}};
const FigureRecord speed = {"speed",
                            {{"queries", "1000"}},
                            {{"machine", "one"}, {"compiler", "c"}},
                            0.1,
                            {interval_row("gjk a", 0.9, 1, 1.1),
                             {"gjk a", "bytes", 100},
                             interval_row("gjk b", 1.9, 2, 2.1),
                             {"gjk b", "bytes", 80}}};

std::string complaint(const std::string& text, std::string_view kind = {}) {
    return complaint_of([&] { return parse_record(text, "mine.json", kind); });
}

/// Returns one line for every row that is not equal, in the order in which rows are shown.
std::vector<std::string> lines(const RecordComparison& found) {
    std::vector<std::string> all;
    const json parsed = json::parse(to_json(found));
    for (const json& row : parsed["rows"])
        all.push_back(row["outcome"].get<std::string>() + " " + row["cell"].get<std::string>() + ":" +
                      row["figure"].get<std::string>());
    return all;
}

TEST(Record, IsTheSameWhenItIsReadAgain) {
    FigureRecord odd = speed;
    odd.rows.push_back({"", "third", 1.0 / 3});
    odd.rows.push_back({"", "large", 1e15 + 0.125});
    odd.rows.push_back({.cell = "claim", .figure = "verdict", .text = "reproduced"});
    const FigureRecord again = parse_record(to_json(odd), "mine.json", "speed");
    EXPECT_EQ(json::parse(to_json(again)), json::parse(to_json(odd)));
    EXPECT_EQ(again.with, odd.with);
    EXPECT_EQ(again.slack, 0.1);
    const RecordComparison found = compare(odd, again);
    EXPECT_TRUE(found.passed());
    EXPECT_EQ(found.compared(), odd.rows.size() + 1);
    EXPECT_EQ(found.count(Outcome::equal), 6u) << "and times with intervals that overlap";
    EXPECT_THAT(to_json(lock), AllOf(HasSubstr("\"bytes\": 24000,"), testing::Not(HasSubstr("slack"))));
}

/// Locks of version 0.1 are understood to the end, or refused; other records of that version say what to do.
TEST(Record, OfAnEarlierVersionIsReadOrRefused) {
    EXPECT_EQ(complaint(R"({"edgewise_lock": 1, "of": {}, "figures": {"bytes": 1}})"), "");
    EXPECT_THAT(complaint(R"({"edgewise_lock": 1, "of": {}, "slak": 1})"),
                HasSubstr("'slak' is not a member of"));
    for (const char* old : {R"({"gate": 1, "entries": []})", R"({"edgewise_machine_record": 1, "rows": []})"})
        EXPECT_THAT(complaint(old), AllOf(HasSubstr("version 0.1"), HasSubstr("write it again"))) << old;
    const FigureRecord of_lock = parse_record(
        R"({"edgewise_lock": 1, "of": {"points": "1000", "tree": "k-d"},
            "figures": {"bytes": 24000, "lines_per_query": 14.1, "knee_bytes": 0}})",
        "mine.json", "lock");
    EXPECT_EQ(to_json(of_lock), to_json(lock));
}

/// Without slack every difference is one; each is named with both values, in the lock's order.
TEST(Record, WithoutSlackMustStay) {
    FigureRecord now = lock;
    now.of[0].second = "1001";
    now.rows[1].value = 14.100000000000001;
    now.rows[2].figure = "misses";
    now.rows[2].value = 2;
    EXPECT_EQ(to_text(compare(lock, now), "mine.json"),
              "changed: of.points: was 1000, is 1001\n"
              "changed: lines_per_query: was 14.1, is 14.100000000000001\n"
              "missing: knee_bytes: was 0, is nothing\n"
              "new: misses: was nothing, is 2\n"
              "mine.json: failed; 4 rows compared: 2 changed, 1 missing, 1 new, 2 equal\n");
    EXPECT_EQ(compare(lock, lock).exit_code(), 0);
    for (const std::size_t row : {0, 1, 2}) {
        FigureRecord less = lock, smaller = lock;
        less.rows.erase(less.rows.begin() + static_cast<std::ptrdiff_t>(row));
        smaller.rows[row].value -= 1;
        EXPECT_EQ(compare(lock, less).exit_code(), 1) << "gone";
        EXPECT_EQ(compare(less, lock).exit_code(), 1) << "new";
        EXPECT_EQ(compare(lock, smaller).exit_code(), 1) << "less is no better in a lock";
    }
}

/// Exact figures are worse where they grew at all, others where the whole interval did, by more than the
/// slack.
TEST(Record, WithSlackFailsWhereItBecameWorse) {
    FigureRecord now = speed;
    now.rows[0] = interval_row("gjk a", 1.22, 1.3, 1.4);
    now.rows[1].value = 101;
    now.rows[2] = interval_row("gjk b", 1.5, 1.6, 1.72);
    now.rows[3].value = 79;
    const RecordComparison found = compare(speed, now);
    EXPECT_EQ(found.exit_code(), 1);
    EXPECT_THAT(lines(found), ElementsAre("worse gjk a:time", "worse gjk a:bytes", "better gjk b:bytes",
                                          "better gjk b:time"));
    EXPECT_THAT(
        to_text(found, "old.json"),
        AllOf(HasSubstr("worse: gjk a: time: was 1 [0.9, 1.1], is 1.3 [1.22, 1.4], x 1.300 [1.109, 1.556]\n"),
              HasSubstr("worse: gjk a: bytes: was 100, is 101\n"), HasSubstr("old.json: failed; ")));
    now.rows[0] = interval_row("gjk a", 1.20, 1.3, 1.4);
    now.rows[1].value = 100;
    now.rows[2] = interval_row("gjk b", 1.5, 1.6, 1.74);
    EXPECT_THAT(lines(compare(speed, now)),
                ElementsAre("better gjk b:bytes", "within gjk a:time", "within gjk b:time"));
    EXPECT_TRUE(compare(speed, now).passed());
}

/// Limits of the old record decide before its other rules, each figure by the first pattern that matches.
TEST(Record, LimitsSayHowFarAFigureMayGo) {
    FigureRecord old = lock;
    old.rows = {{"", "bytes", 1000}, {"", "misses.L1", 10}, {"", "misses.L2", 10}, {"", "steps", 5}};
    old.limits = {{"bytes", {}, 1200}, {"misses.L1", 0.5, {}}, {"misses.*", 0.1, 14}};
    EXPECT_EQ(json::parse(to_json(old))["limits"],
              json::parse(R"({"bytes": {"hard": 1200}, "misses.L1": {"soft": 0.5},
                              "misses.*": {"soft": 0.1, "hard": 14}})"));
    EXPECT_EQ(to_json(parse_record(to_json(old), "mine.json", "lock")), to_json(old));
    const auto outcome = [&](std::size_t row, double value) {
        FigureRecord now = old;
        now.rows[row].value = value;
        const RecordComparison found = compare(old, now);
        return lines(found).empty() ? "equal"
                                    : lines(found)[0].substr(0, lines(found)[0].find(' ')) + " " +
                                          std::to_string(found.exit_code());
    };
    EXPECT_EQ(outcome(0, 1200), "within 0") << "only a hard limit: it may grow up to that";
    EXPECT_EQ(outcome(0, 1201), "over 3");
    EXPECT_EQ(outcome(0, 999), "better 0");
    EXPECT_EQ(outcome(1, 14), "within 0") << "the first soft limit, and the hard one of the other pattern";
    EXPECT_EQ(outcome(1, 14.1), "over 3");
    EXPECT_EQ(outcome(2, 11), "within 0");
    EXPECT_EQ(outcome(2, 11.1), "worse 1");
    EXPECT_EQ(outcome(3, 4), "changed 1") << "no limit: it must stay";
}

TEST(Record, LimitsAreNamedAndRefused) {
    FigureRecord old = lock;
    old.limits = {{"bytes", {}, 24100}};
    FigureRecord now = old;
    now.rows[0].value = 24101;
    EXPECT_THAT(to_text(compare(old, now), "mine.json"),
                HasSubstr("over: bytes: was 24000, is 24101\n    hard limit 24100\n"));
    EXPECT_THAT(
        complaint(R"({"edgewise_record": "lock", "figures": {"b": 1}, "limits": {"c": {"soft": 1}}})"),
        HasSubstr("limits.c: the record has no such figure"));
    EXPECT_THAT(complaint(R"({"edgewise_record": "lock", "figures": {"b": 1}, "limits": {"b": {"sof": 1}}})"),
                HasSubstr("did you mean 'soft'"));
    EXPECT_THAT(
        complaint(R"({"edgewise_record": "lock", "figures": {"b": 1}, "limits": {"b": {"soft": -1}}})"),
        HasSubstr("limits.b.soft: needs a number from 0 on"));
    FigureRecord timed = speed;
    timed.limits = {{"time", 0.5, 3}};
    now = speed;
    now.rows[0] = interval_row("gjk a", 1.3, 1.4, 1.5);
    EXPECT_TRUE(compare(timed, now).passed()) << "beyond the slack, within the limit";
    now.rows[0] = interval_row("gjk a", 3.1, 3.2, 3.3);
    EXPECT_EQ(compare(timed, now).exit_code(), 3);
}

TEST(Record, ALoneCellIsOneRowAndFailsNothing) {
    FigureRecord now = speed;
    for (std::size_t i : {2, 3}) now.rows[i].cell = "gjk fresh";
    const RecordComparison found = compare(speed, now);
    EXPECT_THAT(lines(found), ElementsAre("missing gjk b:", "new gjk fresh:", "within gjk a:time"));
    EXPECT_TRUE(found.passed());
    now.rows.erase(now.rows.begin(), now.rows.begin() + 2);
    now.of.clear();
    EXPECT_FALSE(compare(speed, now).passed());
    EXPECT_THAT(to_text(compare(speed, now), "old.json"),
                HasSubstr("old.json: failed, nothing in common; 0 rows"));
}

TEST(Record, AnotherMachineIsAPossibleCause) {
    FigureRecord now = speed;
    now.with = {{"compiler", "c"}, {"machine", "two"}, {"flags", "-O3"}};
    RecordComparison found = compare(speed, now);
    EXPECT_TRUE(found.passed());
    EXPECT_THAT(to_text(found, "old.json"),
                AllOf(HasSubstr("possible cause: machine: was one, is two\n"),
                      HasSubstr("possible cause: flags: was ?, is -O3\n"),
                      HasSubstr("excluded as causes, being the same: compiler\n")));
    found.faults = {"wrong answers: gjk a"};
    EXPECT_EQ(found.exit_code(), 1);
    EXPECT_THAT(to_text(found, "old.json"), HasSubstr("failed: wrong answers: gjk a\n"));
}

TEST(Record, SaysWhatAFileNeeds) {
    const std::string right = to_json(speed);
    for (const std::size_t kept : {std::size_t{0}, std::size_t{1}, right.size() / 2, right.size() - 3})
        EXPECT_THAT(complaint(right.substr(0, kept)),
                    AllOf(HasSubstr("mine.json: not JSON"), HasSubstr("edgewise_record")));
    const std::vector<std::pair<std::string, std::string>> faults = {
        {"[]", "needs an object"},
        {R"({"edgewise_lock": 2})", "edgewise_record: needs the kind"},
        {R"({"edgewise_record": "lock", "of": {"a": 1}})", "of.a: needs a text"},
        {R"({"edgewise_record": "lock", "figures": 3})", "figures: needs an object"},
        {R"({"edgewise_record": "lock", "figures": {"b": null}})", "b: needs a number"},
        {R"({"edgewise_record": "lock", "cells": {"c": {"b": [1, 2]}}})", "c: b: needs a number"},
        {R"({"edgewise_record": "lock", "cells": {"c": {"b": [2, 1, 3]}}})", "c: b: needs a number"},
        {R"({"edgewise_record": "lock", "cells": {"c": {"b": [0, 0, 0]}}})", "c: b: needs a number"},
        {R"({"edgewise_record": "lock", "slack": -0.1})", "slack: needs a number"},
        {R"({"edgewise_record": "lock", "figure": {}})", "did you mean 'figures'"}};
    for (const auto& [text, said] : faults)
        EXPECT_THAT(complaint(text), AllOf(testing::StartsWith("mine.json: "), HasSubstr(said))) << text;
    EXPECT_THAT(complaint(right, "lock"), HasSubstr("needs one of kind 'lock'"));
    EXPECT_THROW(static_cast<void>(read_record("/nowhere/at/all.json")), std::runtime_error);
    EXPECT_EQ(lock.condition("tree", "f"), "k-d");
    EXPECT_THROW(static_cast<void>(lock.condition("leaf", "f")), std::runtime_error);
}

/// Populations that are not there have no figures: an absence is a difference, not a 0.
TEST(Record, OfALayoutHasFiguresOfPopulationsThatAreThere) {
    LayoutFacts facts;
    facts.bytes = {{"nodes.a", 10}, {"nodes.b", 5}};
    facts.lines.all = facts.lines.warm = {4, 9, 30, 6};
    facts.knee_bytes.all = facts.knee_bytes.warm = 128;
    LevelMisses level{"L1", 9, 0, {1, 2, 3}, {6}, {6}};
    MachineMisses misses;
    misses.caches = {level};
    facts.machines = {{"small", {misses, {}, misses}, {10, 0, 10}}};
    using Figure = std::pair<std::string, double>;
    std::vector<Figure> figures;
    for (const RecordRow& row : lock_of(facts).rows) figures.emplace_back(row.figure, row.value);
    EXPECT_THAT(figures, ElementsAre(Figure{"bytes.nodes.a", 10}, Figure{"bytes.nodes.b", 5},
                                     Figure{"bytes", 15}, Figure{"distinct_lines", 0}, Figure{"queries", 4},
                                     Figure{"lines_per_query", 1.5}, Figure{"knee_bytes", 128},
                                     Figure{"queries.warm", 4}, Figure{"lines_per_query.warm", 1.5},
                                     Figure{"knee_bytes.warm", 128}, Figure{"misses_per_query.small.L1", 1.5},
                                     Figure{"emptied_misses_per_query.small.L1", 2.5},
                                     Figure{"misses_per_query.small.L1.warm", 1.5},
                                     Figure{"emptied_misses_per_query.small.L1.warm", 2.5}));
}

}  // namespace
}  // namespace edgewise::measure
