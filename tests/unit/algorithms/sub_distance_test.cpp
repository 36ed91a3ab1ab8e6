// SPDX-License-Identifier: MIT
//
// GJK's sub-distance solves with the solver that was chosen: to the bit the answer of that solver
// by itself, where it is sure. Points are of a lattice, all but a rounding step: there, and nowhere
// else, the two differ.
#include "edgewise/algorithms/sub_distance.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/query_batch.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/points_soa.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise {
namespace {

/// Points of the difference, slightly off those of a lattice: the origin's nearest point often lies on the
/// border between two subsets.
template <class Scalar>
SimplexPoints<Scalar> beside_a_lattice(scene::Rng& rng) {
    const auto third = static_cast<Scalar>(1.0 / 3);
    SimplexPoints<Scalar> points;
    for (auto& point : points) {
        const Vec3<Scalar> place = rng.in_cube(3).array().round().cast<Scalar>();
        point = place * third + Vec3<Scalar>::Constant(Scalar(2));
        point.x() -= Scalar(2);
    }
    return points;
}

template <class Scalar>
bool is_sure(const ClosestOfSimplex<Scalar>& closest, const SimplexPoints<Scalar>& points, int count) {
    if (closest.members == 15) return true;
    Scalar size = 0;
    for (int i = 0; i < count; ++i) size = std::max(size, max_abs(points[i]));
    const Scalar close = Tolerance<Scalar>::close * size;
    return !closest.backup && !closest.thin && squared_norm(closest.point) >= close * close;
}

template <class Scalar>
ClosestOfSimplex<Scalar> by_itself(SubDistanceSolver solver, const SimplexPoints<Scalar>& points, int count) {
    Johnson<Scalar> johnson(points, count);
    if (solver == SubDistanceSolver::johnson) return johnson.closest();
    if (johnson.holds_origin()) return johnson.inside();
    ClosestOfSimplex<Scalar> found;
    find_closest(points, count, false, found);
    return found;
}

template <class Scalar>
bool same_closest(const ClosestOfSimplex<Scalar>& a, const ClosestOfSimplex<Scalar>& b) {
    return a.members == b.members && a.point == b.point;
}

struct Solved {
    int sure = 0, wrong = 0, apart = 0;  ///< apart: the other solver says otherwise
};

template <class Table>
Solved solve(SubDistanceSolver solver) {
    using Scalar = ComputeOf<Table>;
    const auto other =
        solver == SubDistanceSolver::johnson ? SubDistanceSolver::cofactors : SubDistanceSolver::johnson;
    scene::Rng rng(5);
    Solved solved;
    for (int i = 0; i < 50000; ++i) {
        const int count = 1 + static_cast<int>(rng.below(4));
        const auto points = beside_a_lattice<Scalar>(rng);
        const auto expected = by_itself(solver, points, count);
        if (!is_sure(expected, points, count)) continue;
        SubDistance<Table, Table> sub(solver);
        for (int k = 0; k < count; ++k) sub.add({}, {}, points[k], Vec3<Scalar>::Zero());
        sub.solve_first();
        ++solved.sure;
        solved.wrong += !same_closest(sub.closest(), expected);
        solved.apart += !same_closest(by_itself(other, points, count), expected);
    }
    return solved;
}

template <class Table>
class SubDistances : public ::testing::Test {};
using SubDistanceTables = ::testing::Types<points_soa<f64>, points_soa<f32>>;
TYPED_TEST_SUITE(SubDistances, SubDistanceTables);

TYPED_TEST(SubDistances, SolveWithTheSolverThatWasChosen) {
    for (const auto solver : {SubDistanceSolver::cofactors, SubDistanceSolver::johnson}) {
        const Solved solved = solve<TypeParam>(solver);
        std::printf("%s: %d simplices, %d wrong, %d where the other says otherwise\n",
                    std::string(to_string(solver)).c_str(), solved.sure, solved.wrong, solved.apart);
        EXPECT_GT(solved.sure, 10000);
        EXPECT_EQ(solved.wrong, 0);
        EXPECT_GT(solved.apart, 0) << "else the test would show nothing";
    }
}

/// Bodies of lattice points in thirds: their differences are such points, too. Each is the hull of `points`
/// points of a sphere, rounded to the lattice.
template <class Table>
std::vector<Table> lattice_bodies(scene::Rng& rng, int points, double radius) {
    std::vector<Table> tables;
    while (tables.size() < 40) {
        std::vector<Vec3d> some;
        for (int i = 0; i < points; ++i) some.emplace_back((radius * rng.on_sphere()).array().round() / 3);
        if (const auto body = convex_hull(some)) tables.emplace_back(*body, Parts::support);
    }
    return tables;
}

template <class Table>
std::vector<PairQuery<Table, Table>> lattice_queries(const std::vector<Table>& tables, scene::Rng& rng,
                                                     int count, double offsets) {
    std::vector<PairQuery<Table, Table>> queries;
    for (int i = 0; i < count; ++i) {
        const Table* a = &tables[rng.below(tables.size())];
        const Table* b = &tables[rng.below(tables.size())];
        const Vec3d offset = rng.in_cube(offsets).array().round() / 3;
        queries.push_back({a, b, {Mat3d::Identity(), offset}, nullptr});
    }
    return queries;
}

/// Cold, one after the other or in a batch.
template <class Table>
std::vector<Distance> answers_of(std::vector<PairQuery<Table, Table>> queries, SubDistanceSolver solver,
                                 bool batch) {
    std::vector<SimplexPair<Table, Table>> pairs(queries.size());
    std::vector<Distance> answers(queries.size());
    const QueryOptions options{.sub_distance = solver};
    for (std::size_t i = 0; i < queries.size(); ++i) {
        queries[i].pair = &pairs[i];
        if (!batch)
            answers[i] = Gjk::query(*queries[i].a, *queries[i].b, queries[i].a_from_b, pairs[i], options);
    }
    if (batch) query_batch<Table, Table>(queries, answers, options);
    return answers;
}

bool same_answer(const Distance& a, const Distance& b) {
    return a.status == b.status && a.distance == b.distance && a.point_a == b.point_a &&
           a.point_b == b.point_b;
}

/// Whole queries: other bits somewhere, so the option reaches the run, and nowhere another answer, but where
/// the distance is within the verdict's band: bodies that touch in lattice points, which single precision
/// rounds. A batch, with lanes that know only cofactors, gives the bits of single queries.
template <class Table>
void expect_the_chosen_solver(const std::vector<PairQuery<Table, Table>>& queries) {
    const auto by_signs = answers_of(queries, SubDistanceSolver::cofactors, false),
               by_search = answers_of(queries, SubDistanceSolver::johnson, false),
               batch = answers_of(queries, SubDistanceSolver::johnson, true);
    int other_bits = 0, other_verdicts = 0, other_in_batch = 0;
    double apart = 0;
    const double eps{Tolerance<ComputeOf<Table>>::eps}, band = verdict_band_steps * eps;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const double distance = std::max(by_signs[i].distance, by_search[i].distance);
        other_verdicts +=
            (by_signs[i].status == Status::separated) != (by_search[i].status == Status::separated) &&
            distance > band;
        other_bits += !same_answer(by_signs[i], by_search[i]);
        other_in_batch += !same_answer(batch[i], by_search[i]);
        apart = std::max(apart, std::abs(by_signs[i].distance - by_search[i].distance));
    }
    std::printf(
        "%d answers of other bits, %d of another verdict, distances %.3g apart; %d other in a batch\n",
        other_bits, other_verdicts, apart, other_in_batch);
    EXPECT_GT(other_bits, 0);
    EXPECT_EQ(other_verdicts, 0);
    EXPECT_EQ(other_in_batch, 0);
    EXPECT_LE(apart, 100 * eps);
}

TYPED_TEST(SubDistances, QueriesSolveWithTheSolverThatWasChosen) {
    scene::Rng rng(6);
    const auto tables = lattice_bodies<TypeParam>(rng, 6, 2);
    expect_the_chosen_solver(lattice_queries(tables, rng, 50000, 6));
}

/// Bodies that are not small are never searched in singles: other bits come from the run alone.
TYPED_TEST(SubDistances, QueriesOfLargeBodiesToo) {
    scene::Rng rng(8);
    const auto tables = lattice_bodies<TypeParam>(rng, 400, 20);
    EXPECT_FALSE(is_small(tables[0]));
    expect_the_chosen_solver(lattice_queries(tables, rng, 20000, 60));
}

}  // namespace
}  // namespace edgewise
