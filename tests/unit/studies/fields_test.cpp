// SPDX-License-Identifier: MIT
//
// Fields that are read together: counts of a synthetic trace, the best groups compared with all groups, and a
// replayed trace compared, access by access, with the trace of a table built in those groups.
#include "edgewise/studies/fields/fields.hpp"

#include <gmock/gmock.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "../complaint.hpp"
#include "../temporary_folder.hpp"
#include "edgewise/bench/trace/trace_places.hpp"
#include "edgewise/layout_parts/stored_fields.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::studies {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Builds traces by hand: fields a, b and c of one record, d of another; 24 bytes each, b and c if not said
/// otherwise.
class MadeUpTrace {
  public:
    explicit MadeUpTrace(std::uint32_t bytes = 24, std::uint32_t alignment = 8) {
        FieldMap& table = trace_.tables.emplace_back();
        table.fields = {{"a", "one", 24, 8},
                        {"b", "one", bytes, alignment},
                        {"c", "one", bytes, alignment},
                        {"d", "other", 24, 8}};
        for (std::uint8_t field = 0; field < 3; ++field)
            table.places.push_back({.element = 99, .field = field});
        table.places.push_back({.element = 49, .field = 3});
    }
    MadeUpTrace& query() {
        if (trace_.queries++ > 0) trace_.events.push_back({.kind = FieldEvent::Kind::query_end});
        trace_.events.push_back({.kind = FieldEvent::Kind::query_start});
        return *this;
    }
    MadeUpTrace& step() {
        trace_.events.push_back({.kind = FieldEvent::Kind::step_start});
        return *this;
    }
    MadeUpTrace& read(std::uint8_t field, std::uint32_t element,
                      measure::TraceSide side = measure::TraceSide::table_a) {
        FieldEvent event{.kind = FieldEvent::Kind::field, .field = {0, element, field, 0}};
        event.access = {0, 24, measure::AccessKind::read, 0, 0, side};
        trace_.events.push_back(event);
        return *this;
    }
    FieldTrace end() {
        trace_.events.push_back({.kind = FieldEvent::Kind::query_end});
        return trace_;
    }

  private:
    FieldTrace trace_;
};

TEST(CoAccess, CountsQueriesStepsAndRecords) {
    MadeUpTrace made;
    made.query().step().read(0, 7).read(1, 7).read(0, 7).step().read(2, 7).read(3, 7);
    made.query().step().read(0, 7).read(1, 8).step().step().read(0, 3).read(0, 3,
                                                                            measure::TraceSide::table_b);
    const CoAccess together = co_access(made.end());
    EXPECT_EQ(together.queries, 2U);
    EXPECT_EQ(together.steps, 4U) << "a step that reads nothing is none";
    EXPECT_THAT(together.by_query, ElementsAre(ElementsAre(2, 2, 1, 1), ElementsAre(2, 2, 1, 1),
                                               ElementsAre(1, 1, 1, 1), ElementsAre(1, 1, 1, 1)));
    EXPECT_THAT(together.by_step, ElementsAre(ElementsAre(3, 2, 0, 0), ElementsAre(2, 2, 0, 0),
                                              ElementsAre(0, 0, 1, 1), ElementsAre(0, 0, 1, 1)));
    // a and b of record 7 once; c and d, both of number 7, are of different records.
    EXPECT_THAT(together.by_record, ElementsAre(ElementsAre(4, 1, 0, 0), ElementsAre(1, 2, 0, 0),
                                                ElementsAre(0, 0, 1, 0), ElementsAre(0, 0, 0, 1)));
    EXPECT_DOUBLE_EQ(CoAccess::overlap(together.by_step, 0, 1), 2.0 / 3.0);
    EXPECT_DOUBLE_EQ(CoAccess::overlap(together.by_step, 0, 2), 0);
}

std::uint64_t lines_of(const FieldTrace& trace, const FieldGroups& groups) {
    measure::LineCounter lines;
    replay(trace, GroupedPlaces(trace.tables, groups), lines);
    return lines.sums().all.lines;
}

FieldGroups groups_by(const std::vector<std::vector<std::uint8_t>>& groups) {
    FieldGroups result;
    for (const auto& group : groups) result.add(group);
    return result;
}

TEST(BestGroups, AreAsGoodAsAnyOfAllThereAre) {
    scene::Rng rng(3);
    std::size_t differ = 0;
    for (int turn = 0; turn < 20; ++turn) {
        MadeUpTrace made;
        const std::uint64_t habit = rng.below(8);  // which fields a query likes to read of one record
        for (int query = 0; query < 30; ++query) {
            made.query().step();
            for (int reads = 0; reads < 4; ++reads) {
                const auto element = static_cast<std::uint32_t>(rng.below(100));
                for (std::uint8_t field = 0; field < 3; ++field)
                    if ((habit >> field & 1) != 0 || rng.below(4) == 0) made.read(field, element);
            }
        }
        const FieldTrace trace = made.end();
        std::vector<std::uint64_t> all;
        for (const auto& groups : std::vector<std::vector<std::vector<std::uint8_t>>>{{{0}, {1}, {2}, {3}},
                                                                                      {{0, 1}, {2}, {3}},
                                                                                      {{0, 2}, {1}, {3}},
                                                                                      {{1, 2}, {0}, {3}},
                                                                                      {{0, 1, 2}, {3}}})
            all.push_back(lines_of(trace, groups_by(groups)));
        const std::uint64_t best = *std::min_element(all.begin(), all.end());
        EXPECT_LE(lines_of(trace, best_groups(trace)), best);
        differ += *std::max_element(all.begin(), all.end()) > best;
    }
    EXPECT_GT(differ, 10U) << "groups must matter";
}

/// Also where one would fill what alignment leaves behind a and b, at the cost of no line.
TEST(BestGroups, FieldsThatNobodyReadsAreApart) {
    for (const auto& [bytes, alignment] : {std::pair{24U, 8U}, std::pair{4U, 4U}}) {
        MadeUpTrace made(bytes, alignment);
        for (std::uint32_t i = 0; i < 40; ++i) made.query().step().read(0, i).read(1, i);
        const FieldTrace trace = made.end();
        EXPECT_EQ(groups_json(best_groups(trace), trace.fields()).dump(), R"([["a","b"],["c"],["d"]])")
            << bytes;
    }
}

struct Recorded {
    std::vector<measure::TracedAccess> accesses;
    std::size_t steps = 0, queries = 0;
};

class Recorder final : public measure::TraceListener {
  public:
    void on_step_start(std::uint8_t /*step*/) override { ++recorded.steps; }
    void on_access(const measure::TracedAccess& access) override { recorded.accesses.push_back(access); }
    void on_query_end(bool /*counts*/) override { ++recorded.queries; }

    Recorded recorded;
};

void expect_same(const Recorded& predicted, const Recorded& counted, const std::string& what) {
    ASSERT_EQ(predicted.accesses.size(), counted.accesses.size()) << what;
    EXPECT_EQ(predicted.steps, counted.steps) << what;
    EXPECT_EQ(predicted.queries, counted.queries) << what;
    for (std::size_t i = 0; i < predicted.accesses.size(); ++i) {
        const measure::TracedAccess &a = predicted.accesses[i], &b = counted.accesses[i];
        const bool same = a.address == b.address && a.bytes == b.bytes && a.kind == b.kind &&
                          a.field == b.field && a.step == b.step && a.side == b.side;
        ASSERT_TRUE(same) << what << ", access " << i << ": " << a.address << " predicted, " << b.address;
    }
}

CellChoice small(const std::string& table, const std::string& algorithm) {
    return {.table = table, .algorithm = algorithm, .shape = "sphere66", .queries = 60};
}

/// Groups at random: every field somewhere, with others of its record.
FieldGroups random_groups(const std::vector<RecordField>& fields, scene::Rng& rng) {
    std::vector<std::vector<std::uint8_t>> groups;
    for (std::uint8_t field = 0; field < fields.size(); ++field) {
        const std::size_t place = rng.below(groups.size() + 1);
        const bool joins =
            place < groups.size() && fields[groups[place].front()].record == fields[field].record;
        if (!joins) groups.emplace_back();
        std::vector<std::uint8_t>& to = joins ? groups[place] : groups.back();
        to.insert(to.begin() + static_cast<std::ptrdiff_t>(rng.below(to.size() + 1)), field);
    }
    return groups_by(groups);
}

class Prediction {
  public:
    Prediction(const std::string& table, const std::string& algorithm)
        : what_(table + " " + algorithm),
          cell_(small(table, algorithm)),
          trace_(trace_fields(cell_.runner(), bench::TraceExtent::everything(), table)) {}

    [[nodiscard]] const FieldTrace& trace() const { return trace_; }

    [[nodiscard]] bool moves_caches_of_pairs(const FieldGroups& groups) const {
        const auto page_after = bench::TracePlaces::page_after;
        return page_after(GroupedPlaces(trace_.tables, groups).taken()) != page_after(trace_.taken);
    }
    void expect_of_itself(const FieldGroups& groups) const {
        expect_same(told(groups), asked(cell_), what_ + " as it is");
    }
    void expect_of_built(const FieldGroups& groups) const {
        const FieldsGroupedBy<StoredField> chosen(groups);
        const SingleCell built(small("grouped_f64", cell_.algorithm()));
        expect_same(told(groups), asked(built), what_ + " as " + groups_json(groups, trace_.fields()).dump());
        const std::vector<Distance> before = cell_.runner().answer(), after = built.runner().answer();
        ASSERT_EQ(before.size(), after.size());
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_EQ(before[i].distance, after[i].distance);
            EXPECT_EQ(before[i].point_a, after[i].point_a);
        }
    }

  private:
    [[nodiscard]] Recorded told(const FieldGroups& groups) const {
        Recorder recorder;
        replay(trace_, GroupedPlaces(trace_.tables, groups), recorder);
        return recorder.recorded;
    }
    [[nodiscard]] static Recorded asked(const SingleCell& cell) {
        Recorder recorder;
        static_cast<void>(cell.runner().trace(bench::TraceExtent::everything(), recorder));
        EXPECT_GT(recorder.recorded.accesses.size(), 1000U);
        return recorder.recorded;
    }

    std::string what_;
    SingleCell cell_;
    FieldTrace trace_;
};

TEST(FieldPlaces, OfItsOwnGroupsAreATableAsItIs) {
    for (const char* algorithm : {"vclip", "gjk"}) {
        for (const char* table : {"aos_f64", "hot_cold_f64"}) {
            const Prediction prediction(table, algorithm);
            const auto own = groups_of(prediction.trace().tables.front());
            ASSERT_TRUE(own) << table;
            prediction.expect_of_itself(*own);
            prediction.expect_of_built(*own);
        }
    }
}

/// Also where the tables take another number of pages, which moves the caches of pairs behind them.
TEST(FieldPlaces, OfAnyGroupsAreThoseOfATableBuiltSo) {
    scene::Rng rng(1);
    int moved = 0;
    for (const char* algorithm : {"vclip", "gjk"}) {
        const Prediction records("aos_f64", algorithm);
        for (int turn = 0; turn < 10; ++turn) {
            const FieldGroups groups = random_groups(records.trace().fields(), rng);
            moved += records.moves_caches_of_pairs(groups) ? 1 : 0;
            records.expect_of_built(groups);
        }
    }
    EXPECT_GT(moved, 2);
}

/// Planes, topology and padding by turns: as many shares as an edge can have.
TEST(FieldPlaces, OfGroupsThatAlternateAreThoseOfATableBuiltSo) {
    const Prediction records("aos_f64", "vclip");
    const nlohmann::json groups = {{"tail_plane", "tail", "head_plane", "head", "left_plane", "left",
                                    "direction", "right", "right_plane", "length"},
                                   {"point", "vertex_offset"},
                                   {"face_plane", "face_offset"},
                                   {"neighbour", "vertex_ring"},
                                   {"face_ring"}};
    const TemporaryFolder folder;
    const std::string file = folder.write("groups.json", nlohmann::json{{"groups", groups}}.dump());
    records.expect_of_built(read_groups(file, records.trace().fields()));
}

TEST(FieldTrace, RefusesLayoutsWhoseFieldsHaveNoPlace) {
    for (const std::string table : {"lean_f64", "linked_f64"}) {
        const SingleCell cell(small(table, "gjk"));
        EXPECT_THAT(
            complaint_of<std::invalid_argument>([&] { return trace_fields(cell.runner(), 10, table); }),
            HasSubstr(table + ": this layout does not keep its fields in arrays"));
    }
}

// Files of groups, what is wrong with some, and when advice on fields held.

std::string refusal_of(const std::string& text, const std::vector<RecordField>& fields) {
    const TemporaryFolder folder;
    const std::string file = folder.write("groups.json", text);
    return complaint_of<std::invalid_argument>([&] { return read_groups(file, fields); });
}

TEST(GroupText, SaysWhatIsWrongWithAFile) {
    const std::vector<RecordField> fields = {{"a", "one", 4, 4}, {"b", "one", 8, 8}, {"c", "other", 4, 4}};
    EXPECT_EQ(refusal_of(R"({"groups": [["b", "a"], ["c"]]})", fields), "");
    EXPECT_THAT(refusal_of(R"({"groups": [["a"], ["c"]]})", fields), HasSubstr("field 'b' is in no group"));
    EXPECT_THAT(refusal_of(R"({"groups": [["a", "far"]]})", fields),
                HasSubstr("unknown field 'far'; known: a, b, c"));
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
