// SPDX-License-Identifier: MIT
//
// Compares the ledger with a table's real allocations, to the byte. Checks which parts each algorithm's table
// holds, and that no query allocates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "counted_allocations.hpp"
#include "counted_memory.hpp"
#include "edgewise/algorithms/penetration.hpp"
#include "edgewise/algorithms/penetration/start.hpp"
#include "edgewise/table/contract.hpp"
#include "query_poses.hpp"
#include "stored_bodies.hpp"
#include "tables_under_test.hpp"

namespace edgewise {
namespace {

template <class Type>
class Memory : public ::testing::Test {};
TYPED_TEST_SUITE(Memory, TableTypes);

TEST(CountedAllocations, CountsWhatIsAllocatedAndFreed) {
    const CountedAllocations counted;
    auto number = std::make_unique<double>(1);
    EXPECT_EQ(counted.count(), 1U);
    EXPECT_EQ(counted.live_bytes(), sizeof(double));
    number.reset();
    EXPECT_EQ(counted.count(), 1U);
    EXPECT_EQ(counted.live_bytes(), 0U);
}

/// A table has no memory on the heap outside its ledger; only the table object is not in the ledger.
TYPED_TEST(Memory, TheLedgerIsAllThatLivesOnTheHeap) {
    using Table = typename TypeParam::Table;
    for (const auto& [name, body] : test_bodies<Table>()) {
        for (const Parts parts : {Parts::support, Parts::features}) {
            const CountedAllocations counted;
            const Table table(body, parts);
            const std::size_t live = counted.live_bytes();
            EXPECT_EQ(live, table.ledger().total()) << name;
        }
    }
    std::printf("%s: %zu bytes in the table object\n", TypeParam::name, sizeof(Table));
}

/// A table can be moved; its memory is freed once.
TYPED_TEST(Memory, ATableThatMovedIsTheSameTable) {
    using Table = typename TypeParam::Table;
    static_assert(!std::is_copy_constructible_v<Table>);
    const Polyhedron& body = test_bodies<Table>().front().body;
    CountedMemory memory;
    {
        const TablesIn placed(memory);
        Table first(body, Parts::features);
        const std::size_t bytes = memory.live_bytes();
        const std::byte* const at = first.pieces().front().at;
        const Table second(std::move(first));
        EXPECT_EQ(second.pieces().front().at, at);
        first = Table(body, Parts::support);
        EXPECT_EQ(memory.live_bytes(), bytes + first.ledger().total());
    }
    EXPECT_EQ(memory.live_bytes(), 0U);
}

/// Pieces are the allocated memory, each byte once, and add up to the ledger.
TYPED_TEST(Memory, ThePiecesAreTheLedgerAndWhatWasAskedFor) {
    using Table = typename TypeParam::Table;
    for (const auto& [name, body] : test_bodies<Table>()) {
        for (const Parts parts : {Parts::support, Parts::features}) {
            SCOPED_TRACE(name);
            CountedMemory memory;
            const TablesIn placed(memory);
            const Table table(body, parts);
            EXPECT_EQ(table.ledger().total(), memory.live_bytes());
            Ledger sum;
            std::vector<Piece> pieces = table.pieces();
            EXPECT_FALSE(pieces.empty());
            for (const Piece& piece : pieces) {
                EXPECT_TRUE(memory.hold(piece.at, piece.bytes()));
                EXPECT_LE(piece.shares.bytes(), piece.stride);
                piece.add_to(sum);
            }
            EXPECT_EQ(sum.bytes, table.ledger().bytes);
            std::ranges::sort(pieces, {}, &Piece::at);
            for (std::size_t i = 1; i < pieces.size(); ++i)
                EXPECT_LE(pieces[i - 1].at + pieces[i - 1].bytes(), pieces[i].at);
        }
    }
}

/// True if the rings of vertices follow from the numbers of the vertices.
template <class Table>
inline constexpr bool derives_rings = requires {
    requires Table::derives_rings;
};

TYPED_TEST(Memory, SupportTablesHoldNoPlanes) {
    using Table = typename TypeParam::Table;
    for (const auto& [name, body] : test_bodies<Table>()) {
        const Ledger support = Table(body, Parts::support).ledger();
        if (!keeps_faces<Table>) {
            EXPECT_EQ(support[Component::voronoi_planes], 0U) << name;
            EXPECT_EQ(support[Component::edge_geometry], 0U) << name;
            EXPECT_EQ(support.paper_subtotal(), 0U) << name;
        }
        EXPECT_EQ(support[Component::face_planes] > 0, keeps_faces<Table>) << name;
        EXPECT_GT(support[Component::vertex_coordinates], 0U) << name;
        const bool has_rings = ClimbingTable<Table> && !derives_rings<Table>;
        EXPECT_EQ(support[Component::topology] > 0, has_rings || keeps_faces<Table>) << name;
        if (!has_features<Table>) continue;
        const Ledger features = Table(body, Parts::features).ledger();
        // Equal if all features are derived.
        EXPECT_GE(features.total(), support.total()) << name;
        EXPECT_GE(features[Component::topology], support[Component::topology]) << name;
    }
}

template <class Algorithm, class Table>
void expect_no_allocation(const Polyhedron& body, const std::string& name) {
    const Table a(body, Algorithm::parts), b(body, Algorithm::parts);
    using Pair = typename Algorithm::template Pair<Table, Table>;
    const auto poses = query_poses(300, body, 1);
    Pair warm(a, b);
    PenetrationSpace space;
    int separated = 0, contact = 0;
    std::size_t in_depth = 0;
    const CountedAllocations counted;
    for (const Transform<double>& pose : poses) {
        Pair cold(a, b);
        const Distance first = Algorithm::query(a, b, pose, cold);
        const Distance again = Algorithm::query(a, b, pose, warm);
        ++(first.status == Status::separated ? separated : contact);
        static_cast<void>(again);
        if (first.status == Status::separated) continue;
        const std::size_t before = counted.count();
        static_cast<void>(penetration(a, b, pose, simplex_of(a, b, cold), space));
        in_depth += counted.count() - before;
    }
    // The work space of depths may grow until its worst pair, not with every query.
    EXPECT_LE(in_depth, 10U) << Algorithm::name << " " << name;
    EXPECT_EQ(counted.count(), in_depth) << Algorithm::name << " " << name;
    EXPECT_GT(separated, 50) << name;
    EXPECT_GT(contact, 20) << name;
}

TYPED_TEST(Memory, NoQueryAllocates) {
    using Table = typename TypeParam::Table;
    for (const auto& [name, body] : test_bodies<Table>()) {
        for_each_algorithm<Table>([&, &name = name, &body = body]<class Algorithm>(Algorithm) {
            expect_no_allocation<Algorithm, Table>(body, name);
        });
    }
}

template <class Table>
std::vector<std::byte> bytes_of(const Table& table) {
    std::vector<std::byte> bytes;
    for (const Piece& piece : table.pieces()) bytes.insert(bytes.end(), piece.at, piece.at + piece.bytes());
    return bytes;
}

/// Queries from many threads may share a const table, unless it declares that queries write.
TYPED_TEST(Memory, QueriesWriteOnlyWhereTheTableSaysSo) {
    using Table = typename TypeParam::Table;
    for (const auto& [name, body] : test_bodies<Table>()) {
        const Table table(body, Parts::features);
        const std::vector<std::byte> before = bytes_of(table);
        for_each_algorithm<Table>([&, &body = body]<class Algorithm>(Algorithm) {
            static_cast<void>(answers<Algorithm>(table, table, query_poses(20, body, 4)));
        });
        EXPECT_EQ(bytes_of(table) != before, queries_write<Table>) << name;
    }
}

}  // namespace
}  // namespace edgewise
