// SPDX-License-Identifier: MIT
//
// Compares one table at many scales with a table for each scale: GJK's time over views that stretch a shared
// table (table/scaled_table.hpp) and over tables of the stretched bodies, the memory of both, and the time to
// build or refit a table instead. Both get the same queries of the same points, so that each answer of one is
// compared with the other's, and some with exact ones.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/bench/runner.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/layout_parts/write_geometry.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/table/scaled_table.hpp"
#include "edgewise/table/stored_body.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::bench {

/// Layouts that are measured at many scales say `static constexpr bool measured_at_scales = true`: one of
/// each kind is enough, since each costs the compiler GJK once more.
template <class Table>
inline constexpr bool measured_at_scales = requires {
    requires Table::measured_at_scales;
};

/// The body with every coordinate multiplied by its axis's factor, above 0: as ScaledTable has it where it
/// computes in double.
[[nodiscard]] inline Polyhedron stretched(const Polyhedron& body, const Vec3d& scale) {
    Polyhedron result = body;
    for (Vec3d& vertex : result.vertices) vertex = vertex.cwiseProduct(scale);
    for (Index f = 0; f < body.face_count(); ++f) {
        const Vec3d normal = body.face_planes[f].normal.cwiseQuotient(scale);
        const Vec3d& point = result.vertices[body.tail(body.ring_of_face(f)[0])];
        result.face_planes[f].normal = normal / norm(normal);
        result.face_planes[f].offset = -dot(result.face_planes[f].normal, point);
    }
    return result;
}

/// Whole 64ths from 1/4 to 4, which every precision holds.
[[nodiscard]] inline std::vector<Vec3d> scales_of_instances(std::size_t count) {
    scene::Rng rng(64);
    std::vector<Vec3d> scales(count);
    for (Vec3d& scale : scales)
        for (int k = 0; k < 3; ++k) scale[k] = static_cast<double>(16 + rng.below(241)) / 64;
    return scales;
}

/// Queries of instance i and the next one, which turns before it: warm pairs, some of them in contact.
template <class Table>
class ScalePass {
  public:
    static constexpr std::size_t steps = 24;

    ScalePass(const std::vector<Table>& shapes, double extent) : shapes_(shapes) {
        scene::Rng rng(24);
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            const Mat3d from = rng.rotation();
            const Vec3d place = rng.on_sphere() * (extent * rng.uniform(1, 4));
            places_.push_back({from, place});
            pairs_.emplace_back(shapes[i], next(i));
        }
    }

    [[nodiscard]] const Table& next(std::size_t i) const { return shapes_[(i + 1) % shapes_.size()]; }
    /// The next instance's place, turned about its z axis by an angle with a sine that grows by 0.025 a step.
    [[nodiscard]] Transform<double> a_from_b(std::size_t i, std::size_t step) const {
        const double sine = 0.1 * static_cast<double>(step) / 4, cosine = std::sqrt(1 - sine * sine);
        Mat3d turn;
        turn << cosine, -sine, 0, sine, cosine, 0, 0, 0, 1;
        return {multiply(turn, places_[i].rotation), places_[i].translation};
    }

    /// Runs the queries from cold pairs; returns ns per query.
    [[nodiscard]] EDGEWISE_QUERY_LOOP double run(std::vector<double>& distances) {
        for (std::size_t i = 0; i < shapes_.size(); ++i) pairs_[i] = {shapes_[i], next(i)};
        distances.clear();
        const measure::Stopwatch watch;
        for (std::size_t step = 0; step < steps; ++step)
            for (std::size_t i = 0; i < shapes_.size(); ++i)
                distances.push_back(
                    Gjk::query(shapes_[i], next(i), a_from_b(i, step), pairs_[i], QueryOptions{}).distance);
        return watch.elapsed_ns() / static_cast<double>(distances.size());
    }

  private:
    const std::vector<Table>& shapes_;
    std::vector<Transform<double>> places_;
    std::vector<SimplexPair<Table, Table>> pairs_;
};

/// Study of one body that the table can store.
template <class Table>
class ScaleStudy {
    using View = ScaledTable<Table>;

  public:
    static constexpr std::size_t instances = 64, checked = 128;

    explicit ScaleStudy(const Polyhedron& body) : body_(body), shared_(body, Parts::support) {
        for (const Vec3d& scale : scales_of_instances(instances)) {
            bodies_.push_back(stored_body<Table>(stretched(body, scale)).or_throw());
            views_.emplace_back(shared_, scale);
            own_.emplace_back(bodies_.back(), Parts::support);
        }
        for (const Vec3d& vertex : body.vertices) extent_ = std::max(extent_, 2 * max_abs(vertex));
    }

    [[nodiscard]] ScaleTimes run(int repetitions) {
        ScaleTimes times;
        times.scales = instances;
        times.shared_bytes = static_cast<double>(shared_.ledger().total() + sizeof(Table)) +
                             static_cast<double>(views_.size() * sizeof(View));
        for (const Table& table : own_)
            times.own_bytes += static_cast<double>(table.ledger().total() + sizeof(Table));
        ScalePass<View> shared(views_, extent_);
        ScalePass<Table> own(own_, extent_);
        std::vector<double> of_shared, of_own;
        for (int i = 0; i < repetitions; ++i) {
            times.shared_ns.push_back(shared.run(of_shared));
            times.own_ns.push_back(own.run(of_own));
            time_rebuild(static_cast<std::size_t>(i) % instances, times);
        }
        times.queries = of_shared.size();
        for (std::size_t i = 0; i < of_shared.size(); ++i) times.other_bits += of_shared[i] != of_own[i];
        check(shared, of_shared, times);
        return times;
    }

  private:
    void time_rebuild(std::size_t i, ScaleTimes& times) {
        const measure::Stopwatch build_watch;
        const Table fresh(bodies_[i], Parts::support);
        times.build_ns.push_back(std::max(0.0, build_watch.elapsed_ns() - clock_));
        if constexpr (Refittable<Table>) {
            const measure::Stopwatch refit_watch;
            refit(own_[i], bodies_[i]);
            times.refit_ns.push_back(std::max(0.0, refit_watch.elapsed_ns() - clock_));
        }
    }

    void check(const ScalePass<View>& pass, const std::vector<double>& distances, ScaleTimes& times) const {
        for (std::size_t query = 0; query < distances.size(); query += distances.size() / checked) {
            const std::size_t i = query % instances;
            const Transform<double> b_in_a = pass.a_from_b(i, query / instances);
            const auto exact =
                truth::exact_distance(bodies_[i].vertices, Pose{}, bodies_[(i + 1) % instances].vertices,
                                      {b_in_a.rotation, b_in_a.translation})
                    .or_throw();
            const double size = std::max(4 * extent_, norm(b_in_a.translation));
            times.error = std::max(times.error, std::abs(distances[query] - exact.distance) / size);
            ++times.checked;
        }
    }

    const Polyhedron& body_;
    Table shared_;
    std::vector<Polyhedron> bodies_;
    std::vector<View> views_;
    std::vector<Table> own_;
    double clock_ = measure::calibrate();  ///< ns that reading it costs
    double extent_ = 0;
};

/// Returns the times at scales. Empty if the algorithm reads more than support points, or for other layouts.
template <class Algorithm, class Table>
[[nodiscard]] ScaleTimes time_scales(const Polyhedron& body, int repetitions) {
    if constexpr (std::is_same_v<Algorithm, Gjk> && measured_at_scales<Table>) {
        return ScaleStudy<Table>(body).run(repetitions);
    } else {
        return {};
    }
}

}  // namespace edgewise::bench
