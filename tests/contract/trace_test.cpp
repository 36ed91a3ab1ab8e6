// SPDX-License-Identifier: MIT
//
// The same memory through the tracing loader: the same answers to the bit, and every read inside what the
// table allocated.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <set>

#include "counted_allocations.hpp"
#include "query_poses.hpp"
#include "stored_bodies.hpp"

namespace edgewise {
namespace {

template <class Type>
class Trace : public ::testing::Test {};
TYPED_TEST_SUITE(Trace, TableTypes);

struct Sink {
    const CountedAllocations* table = nullptr;
    std::size_t reads = 0, bytes = 0, outside = 0;
    std::set<Field> fields;

    void read(const void* address, std::size_t size, Field field) {
        ++reads;
        bytes += size;
        outside += !table->hold(address, size);
        if (!fields.count(field)) fields.insert(field);
    }
};

using TracedTable = TableUnderTest::With<Traced<Sink>>;

void expect_same_bits(const Distance& a, const Distance& b) {
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.cycles, b.cycles);
    EXPECT_EQ(a.fallbacks, b.fallbacks);
    EXPECT_EQ(std::memcmp(&a.distance, &b.distance, sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(a.point_a.data(), b.point_a.data(), 3 * sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(a.point_b.data(), b.point_b.data(), 3 * sizeof(double)), 0);
}

/// Answers of cold and warm queries, all poses in turn.
template <class Algorithm, class T>
std::vector<Distance> answers(const T& a, const T& b, const std::vector<Transform<double>>& poses) {
    using Pair = typename Algorithm::template Pair<T, T>;
    Pair warm(a, b);
    std::vector<Distance> result;
    for (const Transform<double>& pose : poses) {
        Pair cold(a, b);
        result.push_back(Algorithm::query(a, b, pose, cold));
        result.push_back(Algorithm::query(a, b, pose, warm));
    }
    return result;
}

template <class Algorithm>
void expect_same_answers(const Polyhedron& body, const std::string& name) {
    const auto poses = query_poses(100, body, 2);
    const CountedAllocations counted;
    const Table table(body, Algorithm::parts);
    Sink sink{&counted, 0, 0, 0, {}};
    const TracedTable traced(table, Traced<Sink>{&sink});
    const auto expected = answers<Algorithm>(table, table, poses);
    const auto found = answers<Algorithm>(traced, traced, poses);
    ASSERT_EQ(expected.size(), found.size());
    for (std::size_t i = 0; i < found.size(); ++i) expect_same_bits(found[i], expected[i]);
    std::printf("%s %s %s: %.1f reads, %.0f bytes a query, %zu fields\n", TableUnderTest::name,
                std::string(Algorithm::name).c_str(), name.c_str(),
                static_cast<double>(sink.reads) / static_cast<double>(found.size()),
                static_cast<double>(sink.bytes) / static_cast<double>(found.size()), sink.fields.size());
    EXPECT_GE(sink.reads, 2 * found.size()) << "each query reads both bodies";
    EXPECT_EQ(sink.outside, 0U) << "reads outside the table's memory";
    EXPECT_TRUE(sink.fields.count(Field::vertex));
}

TYPED_TEST(Trace, AnswersAreTheSameAndEveryReadIsInsideTheTable) {
    for (const auto& [name, body] : test_bodies()) {
        for_each_algorithm<Table>([&, &name = name, &body = body]<class Algorithm>(Algorithm) {
            expect_same_answers<Algorithm>(body, name);
        });
    }
}

}  // namespace
}  // namespace edgewise
