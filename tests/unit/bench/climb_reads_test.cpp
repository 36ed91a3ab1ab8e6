// SPDX-License-Identifier: MIT
//
// Bodies of very many vertices are climbed and walked on, not scanned: how many vertices a query reads, in
// numbers that do not depend on the clock. Up to 24 578 vertices in single, 98 306 in double.
//
// The bound. A climb along an arc over a unit sphere of n vertices reads the vertices near its path, in a
// strip of a spacing on either side. The spacing of n points in triangles is sqrt(8 pi / (sqrt(3) n)) = 3.81
// / sqrt(n), their density n / (4 pi): 0.61 sqrt(n) vertices per radian. From a cold start the top is pi / 2
// away in the mean, on two bodies: 1.9 sqrt(n). Ways along edges are up to 1.15 longer, and the grid is up to
// 1.5 times as fine in places: 3.3, and 4 with some room. On top come rings of six around three points of
// each body. A warm query does the same over the arc by which a step has turned a body.
//
// V-Clip leaves pairs of bodies with so small features (from 6146 vertices in single, 24 578 in double) to
// GJK, so that it reads by climbs too. Single queries may read five times the mean: V-Clip's way is up to pi,
// and if bodies overlap, GJK climbs again for each new direction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <unordered_set>

#include "edgewise/bench/registry.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/points_neighbours.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/loader.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise::bench {
namespace {

constexpr double step_turn = 0.01;  ///< rad
constexpr double most_over_mean = 5;

/// Returns the bound on the mean number of vertices that a query reads; derived above.
double mean_bound(std::size_t vertices, double arc) {
    constexpr double rings = 2 * 3 * 7;
    return rings + 4 * std::sqrt(double(vertices)) * arc / (std::numbers::pi / 2);
}

/// How many vertices each counted query reads, each place once.
class VertexCount final : public measure::TraceListener {
  public:
    void on_access(const measure::TracedAccess& access) override {
        if (access.side == measure::TraceSide::scene) return;
        if (access.field == static_cast<std::uint8_t>(Field::vertex)) of_query_.insert(access.address);
    }
    void on_query_end(bool counts) override {
        if (counts) {
            ++queries_;
            all_ += of_query_.size();
            most_ = std::max(most_, of_query_.size());
        }
        of_query_.clear();
    }

    [[nodiscard]] std::size_t queries() const { return queries_; }
    [[nodiscard]] double mean() const { return double(all_) / double(queries_); }
    [[nodiscard]] double most() const { return double(most_); }

  private:
    std::size_t queries_ = 0, all_ = 0, most_ = 0;
    std::unordered_set<std::uint64_t> of_query_;
};

/// Cold pairs from overlapping to a size apart, or pairs that turn in place.
scene::Workload pairs_of(const Polyhedron& body, bool warm) {
    const Vec3d nowhere = Vec3d::Zero();
    scene::Workload workload;
    workload.bodies = {body};
    workload.instances = {0, 0};
    workload.warm = warm;
    scene::Rng rng(1);
    const auto body_at = [&](const Vec3d& centre) {
        return scene::MovingBody{centre, nowhere, rng.orientation(),
                                 scene::rotation_about(rng.on_sphere(), step_turn)};
    };
    for (std::uint32_t pair = 0; pair < (warm ? 5U : 100U); ++pair) {
        scene::MovingBody a = body_at(nowhere), b = body_at(rng.on_sphere() * rng.uniform(1.95, 4));
        for (int step = 0; step < (warm ? 20 : 1); ++step) {
            workload.queries.push_back(
                {0, 0, pair, scene::pose_of(a, nowhere), scene::pose_of(b, nowhere), 0, 1});
            for (scene::MovingBody* moving : {&a, &b}) scene::advance(*moving, 100);
        }
        ++workload.pair_count;
    }
    return workload;
}

/// copies: places that a vertex on the way is read from.
void expect_few_reads(const TableType& type, const Polyhedron& body, double copies) {
    for (const bool warm : {false, true}) {
        const scene::Workload workload = pairs_of(body, warm);
        const double bound =
            copies * mean_bound(body.vertex_count(), warm ? step_turn : std::numbers::pi / 2);
        for (const std::string& algorithm : type.algorithms) {
            const auto runner = type.make_runner(algorithm);
            ASSERT_EQ(runner->load(workload), "");
            VertexCount count;
            static_cast<void>(runner->trace(workload.queries.size(), count));
            std::printf("%6zu vertices, %s %s %s: %.1f read (most %.0f), bound %.1f\n", body.vertex_count(),
                        type.name.c_str(), algorithm.c_str(), warm ? "warm" : "cold", count.mean(),
                        count.most(), bound);
            EXPECT_GE(count.queries(), 90U);
            EXPECT_LE(count.mean(), bound) << type.name << " " << algorithm;
            EXPECT_LE(count.most(), most_over_mean * bound) << type.name << " " << algorithm;
        }
    }
}

template <class Table>
void expect_walks(const char* shape, double copies) {
    const std::string name = std::string(Table::name) + "_" + std::string(Table::PrecisionType::name);
    const TableType* type = find_table_type(name);
    if (!type) GTEST_SKIP() << "this program has no " << name;
    const Polyhedron body = stored_body<Table>(scene::make_shape(shape).or_throw()).or_throw();
    EXPECT_TRUE(Table(body, Parts::support).climbable()) << name << " " << shape;
    expect_few_reads(*type, body, copies);
}

constexpr const char* in_single[] = {"sphere386", "sphere6146", "sphere24578"};
constexpr const char* in_double[] = {"sphere386", "sphere6146", "sphere24578", "sphere98306"};

TEST(ClimbReads, GrowAsTheRootOfVerticesInLean) {
    for (const char* shape : in_single) expect_walks<lean<f32>>(shape, 1);
    for (const char* shape : in_double) expect_walks<lean<f64>>(shape, 1);
}

/// Where a record has copies of its neighbours, half of a ring has been read from the record before.
TEST(ClimbReads, GrowAsTheRootOfVerticesInPointsNeighbours) {
    for (const char* shape : in_single) expect_walks<points_neighbours<f32>>(shape, 2);
    for (const char* shape : in_double) expect_walks<points_neighbours<f64>>(shape, 2);
}

}  // namespace
}  // namespace edgewise::bench
