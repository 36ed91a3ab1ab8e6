// SPDX-License-Identifier: MIT
//
// Queries through the tracing loader, as the program traces them: they give the same answers to the bit, and
// every read lies inside the memory that the table declares.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "bodies.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/table/loader.hpp"
#include "query_poses.hpp"

namespace edgewise {
namespace {

/// Records reads of tables and compares them with the memory that the only table declares.
class Reads final : public measure::TraceListener {
  public:
    explicit Reads(std::vector<MappedPiece> pieces) : pieces_(std::move(pieces)) {}

    void on_access(const measure::TracedAccess& access) override {
        if (access.side == measure::TraceSide::scene) return;
        ++reads;
        bytes += access.bytes;
        outside += !is_declared(access);
        writes += access.kind == measure::AccessKind::write;
        fields.insert(access.field);
    }
    void on_query_end(bool /*counts*/) override {}

    std::size_t reads = 0, bytes = 0, outside = 0, writes = 0;
    std::set<std::uint8_t> fields;

  private:
    [[nodiscard]] bool is_declared(const measure::TracedAccess& access) const {
        return std::any_of(pieces_.begin(), pieces_.end(), [&](const MappedPiece& piece) {
            return piece.offset <= access.address &&
                   access.address + access.bytes <= piece.offset + piece.stride * piece.count;
        });
    }

    std::vector<MappedPiece> pieces_;
};

/// Workload of a body next to its copy, one pair of bodies.
scene::Workload workload(const Polyhedron& body, bool warm) {
    scene::Workload all;
    all.bodies = {body};
    all.pair_count = 1;
    all.warm = warm;
    for (const Transform<double>& pose : query_poses(100, body, 2)) {
        all.queries.push_back({0, 0, 0, {}, {pose.rotation, pose.translation}});
    }
    return all;
}

class Trace : public testing::TestWithParam<const bench::TableType*> {};

/// Compares traced answers with untraced ones. A runner with one body has one table, which both sides read.
void expect_same_answers(const bench::Runner& runner, std::size_t queries, const std::string& name) {
    std::vector<Distance> expected(queries), found(queries);
    static_cast<void>(runner.prepared_range()(0, queries, expected.data()));
    const auto maps = runner.memory_maps();
    ASSERT_EQ(maps.size(), 1U);
    Reads seen(maps.front().pieces);
    const bench::PassSum sum = runner.trace(queries, seen, found.data());
    ASSERT_EQ(sum.queries, queries);
    for (std::size_t i = 0; i < queries; ++i) expect_same_bits(found[i], expected[i]);
    std::printf("%s: %.1f reads, %.0f bytes per query, %zu fields\n", name.c_str(),
                static_cast<double>(seen.reads) / static_cast<double>(queries),
                static_cast<double>(seen.bytes) / static_cast<double>(queries), seen.fields.size());
    EXPECT_GE(seen.reads, 2 * queries) << "each query reads both bodies";
    EXPECT_EQ(seen.outside, 0U) << name << ": accesses outside what the table declares";
    EXPECT_EQ(seen.writes, 0U) << name;
    EXPECT_TRUE(seen.fields.count(static_cast<std::uint8_t>(Field::vertex))) << name;
}

TEST_P(Trace, AnswersAreTheSameAndEveryReadIsInsideTheTable) {
    int held = 0;
    std::vector<NamedBody> bodies = given_bodies();
    std::ranges::move(boxes(), std::back_inserter(bodies));
    for (const auto& [name, body] : bodies) {
        if (const auto stored = GetParam()->stored_body(body); !stored) {
            std::printf("%s: %s\n", name.c_str(), stored.error.c_str());
            continue;
        }
        ++held;
        for (const std::string& algorithm : GetParam()->algorithms) {
            for (const bool warm : {false, true}) {
                const scene::Workload all = workload(body, warm);
                const auto runner = GetParam()->make_runner(algorithm);
                ASSERT_EQ(runner->load(all), "");
                expect_same_answers(
                    *runner, all.queries.size(),
                    GetParam()->name + " " + algorithm + " " + name + (warm ? " warm" : " cold"));
            }
        }
    }
    EXPECT_GE(held, 5) << "bodies";
}

std::vector<const bench::TableType*> all_types() {
    std::vector<const bench::TableType*> types;
    for (const bench::TableType& type : bench::table_types()) types.push_back(&type);
    return types;
}

INSTANTIATE_TEST_SUITE_P(Of, Trace, testing::ValuesIn(all_types()),
                         [](const auto& type) { return type.param->name; });

}  // namespace
}  // namespace edgewise
