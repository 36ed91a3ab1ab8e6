// SPDX-License-Identifier: MIT
//
// The same memory through the tracing loader: the same answers to the bit, and every read inside the memory
// that the table declares.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <vector>

#include "query_poses.hpp"
#include "same_answers.hpp"
#include "stored_bodies.hpp"

namespace edgewise {
namespace {

template <class Type>
class Trace : public ::testing::Test {};
TYPED_TEST_SUITE(Trace, TableTypes);

/// What the table declares of its memory, by address.
class Declared {
  public:
    explicit Declared(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
        std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) { return a.at < b.at; });
    }
    [[nodiscard]] bool holds(const void* address, std::size_t size) const {
        const auto after =
            std::upper_bound(pieces_.begin(), pieces_.end(), static_cast<const std::byte*>(address),
                             [](const std::byte* wanted, const Piece& piece) { return wanted < piece.at; });
        return after != pieces_.begin() && std::prev(after)->holds(address, size);
    }

  private:
    std::vector<Piece> pieces_;
};

struct Sink {
    const Declared* table = nullptr;
    std::size_t reads = 0, bytes = 0, outside = 0;
    std::set<Field> fields;

    void read(const void* address, std::size_t size, Field field) {
        ++reads;
        bytes += size;
        outside += !table->holds(address, size);
        if (!fields.count(field)) fields.insert(field);
    }
};

using TracedTable = TableUnderTest::With<Traced<Sink>>;

template <class Algorithm>
void expect_same_answers(const Polyhedron& body, const std::string& name) {
    const auto poses = query_poses(100, body, 2);
    const Table table(body, Algorithm::parts);
    const Declared declared(table.pieces());
    Sink sink{&declared, 0, 0, 0, {}};
    const TracedTable traced(table, Traced<Sink>{&sink});
    const auto expected = answers<Algorithm>(table, table, poses);
    const auto found = answers<Algorithm>(traced, traced, poses);
    ASSERT_EQ(expected.size(), found.size());
    for (std::size_t i = 0; i < found.size(); ++i) expect_same_bits(found[i], expected[i]);
    std::printf("%s %s %s: %.1f reads, %.0f bytes per query, %zu fields\n", TableUnderTest::name,
                std::string(Algorithm::name).c_str(), name.c_str(),
                static_cast<double>(sink.reads) / static_cast<double>(found.size()),
                static_cast<double>(sink.bytes) / static_cast<double>(found.size()), sink.fields.size());
    EXPECT_GE(sink.reads, 2 * found.size()) << "each query reads both bodies";
    EXPECT_EQ(sink.outside, 0U) << "reads outside what the table declares";
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
