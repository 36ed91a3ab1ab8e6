// SPDX-License-Identifier: MIT
//
// The ledger beside what a table really allocates, what each algorithm's table holds, and that no query
// allocates.
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

#include "counted_allocations.hpp"
#include "edgewise/algorithms/penetration.hpp"
#include "edgewise/algorithms/penetration/start.hpp"
#include "query_poses.hpp"
#include "stored_bodies.hpp"

namespace edgewise {
namespace {

/// What may come on top of a table's bytes: control blocks of shared pointers, small members of a layout.
constexpr std::size_t bookkeeping = 256;

template <class Type>
class Memory : public ::testing::Test {};
TYPED_TEST_SUITE(Memory, TableTypes);

TYPED_TEST(Memory, CountsWhatIsAllocatedAndFreed) {
    const CountedAllocations counted;
    auto number = std::make_unique<double>(1);
    EXPECT_EQ(counted.count(), 1U);
    EXPECT_EQ(counted.live_bytes(), sizeof(double));
    EXPECT_TRUE(counted.hold(number.get(), sizeof(double)));
    EXPECT_FALSE(counted.hold(number.get(), sizeof(double) + 1));
    number.reset();
    EXPECT_EQ(counted.count(), 1U);
    EXPECT_EQ(counted.live_bytes(), 0U);
}

TYPED_TEST(Memory, TheLedgerIsWhatWasAllocated) {
    for (const auto& [name, body] : test_bodies()) {
        for (const Parts parts : {Parts::support, Parts::features}) {
            const CountedAllocations counted;
            const Table table(body, parts);
            const std::size_t held = counted.live_bytes();
            const Ledger ledger = table.ledger();
            std::size_t sum = 0;
            for (const std::size_t bytes : ledger.bytes) sum += bytes;
            EXPECT_EQ(sum, ledger.total()) << name;
            EXPECT_GE(held, ledger.total()) << name;
            EXPECT_LE(held, ledger.total() + bookkeeping) << name;
        }
    }
}

TYPED_TEST(Memory, SupportTablesHoldNoPlanes) {
    for (const auto& [name, body] : test_bodies()) {
        const Ledger support = Table(body, Parts::support).ledger();
        EXPECT_EQ(support[Component::voronoi_planes], 0U) << name;
        EXPECT_EQ(support[Component::edge_geometry], 0U) << name;
        EXPECT_EQ(support[Component::face_planes], 0U) << name;
        EXPECT_EQ(support.paper_subtotal(), 0U) << name;
        EXPECT_GT(support[Component::vertex_coordinates], 0U) << name;
        EXPECT_GT(support[Component::topology], 0U) << name;
        if (!has_features) continue;
        const Ledger features = Table(body, Parts::features).ledger();
        // Equal where all features are derived.
        EXPECT_GE(features.total(), support.total()) << name;
        EXPECT_GE(features[Component::topology], support[Component::topology]) << name;
    }
}

template <class Algorithm>
void expect_no_allocation(const Polyhedron& body, const std::string& name) {
    const Table a(body, Algorithm::parts), b(body, Algorithm::parts);
    using Pair = typename Algorithm::template Pair<Table, Table>;
    const auto poses = query_poses(300, body, 1);
    Pair warm(a, b);
    PenetrationSpace<Table, Table> space;
    int apart = 0, contact = 0;
    std::size_t in_depth = 0;
    const CountedAllocations counted;
    for (const Transform<double>& pose : poses) {
        Pair cold(a, b);
        const Distance first = Algorithm::query(a, b, pose, cold);
        const Distance again = Algorithm::query(a, b, pose, warm);
        ++(first.status == Status::separated ? apart : contact);
        static_cast<void>(again);
        if (first.status == Status::separated) continue;
        const std::size_t before = counted.count();
        static_cast<void>(penetration(a, b, pose, simplex_of(a, b, cold), space));
        in_depth += counted.count() - before;
    }
    // The work space of depths may grow while it meets its worst pair, not with every query.
    EXPECT_LE(in_depth, 10U) << Algorithm::name << " " << name;
    EXPECT_EQ(counted.count(), in_depth) << Algorithm::name << " " << name;
    EXPECT_GT(apart, 50) << name;
    EXPECT_GT(contact, 20) << name;
}

TYPED_TEST(Memory, NoQueryAllocates) {
    for (const auto& [name, body] : test_bodies()) {
        for_each_algorithm<Table>([&, &name = name, &body = body]<class Algorithm>(Algorithm) {
            expect_no_allocation<Algorithm>(body, name);
        });
    }
}

}  // namespace
}  // namespace edgewise
