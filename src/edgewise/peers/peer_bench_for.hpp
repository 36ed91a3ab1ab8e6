// SPDX-License-Identifier: MIT
//
// The bench of one library: all an adapter has to say is what a shape, a pose and a cache are, and how a
// query is asked. Included by adapters only.
#pragma once

#include <memory>
#include <vector>

#include "edgewise/peers/peer.hpp"

namespace edgewise::peers {

/// The answer of bodies with radii from that of their cores: what libraries that know a radius do as well.
[[nodiscard]] inline PeerAnswer rounded(PeerAnswer cores, double radius_a, double radius_b) {
    if (!cores.answered || !cores.separated) return cores;
    const double gap = cores.distance - (radius_a + radius_b);
    if (gap < 0) return {};
    const Vec3d normal = (cores.point_b - cores.point_a) / cores.distance;
    cores.point_a += radius_a * normal;
    cores.point_b -= radius_b * normal;
    cores.distance = gap;
    return cores;
}

/// Library: types Shape (made of a Polyhedron), Placed (made of a Pose) and Cache (default: cold), and
///     static PeerAnswer query(const Shape&, const Placed&, const Shape&, const Placed&, Cache&,
///                             bool verdict_alone).
template <class Library>
class PeerBenchFor final : public PeerBench {
  public:
    using Shape = typename Library::Shape;
    using Placed = typename Library::Placed;
    using Cache = typename Library::Cache;

    void make_shapes(std::span<const Polyhedron* const> bodies) override {
        shapes_.clear();
        shapes_.reserve(bodies.size());
        for (const Polyhedron* body : bodies) shapes_.push_back(std::make_unique<const Shape>(*body));
    }

    void prepare(std::span<const PeerQuery> queries, std::size_t pairs, bool verdict_alone) override {
        asked_.clear();
        asked_.reserve(queries.size());
        for (const PeerQuery& query : queries) {
            asked_.push_back({shapes_[query.shape_a].get(), shapes_[query.shape_b].get(), query.pair,
                              Placed(query.pose_a), Placed(query.pose_b), query.radius_a, query.radius_b});
        }
        caches_.assign(pairs, Cache{});
        verdict_alone_ = verdict_alone;
    }

    void set_back() override { caches_.assign(caches_.size(), Cache{}); }

    double run(std::size_t first, std::size_t last, PeerAnswer* answers) override {
        double sum = 0;
        for (std::size_t i = first; i < last; ++i) {
            const PeerAnswer answer = ask(asked_[i]);
            if (answers) answers[i] = answer;
            sum += answer.distance;
        }
        return sum;
    }

    [[nodiscard]] std::size_t object_bytes() const override { return sizeof(Shape); }
    [[nodiscard]] std::size_t cache_bytes() const override { return sizeof(Cache); }

  private:
    struct Asked {
        const Shape *a, *b;
        std::uint32_t pair;
        Placed placed_a, placed_b;
        double radius_a, radius_b;
    };

    PeerAnswer ask(const Asked& asked) {
        Cache cold{};
        const bool has_radii = asked.radius_a + asked.radius_b > 0;
        const PeerAnswer answer =
            Library::query(*asked.a, asked.placed_a, *asked.b, asked.placed_b,
                           caches_.empty() ? cold : caches_[asked.pair], verdict_alone_ && !has_radii);
        return has_radii ? rounded(answer, asked.radius_a, asked.radius_b) : answer;
    }

    std::vector<std::unique_ptr<const Shape>> shapes_;
    std::vector<Asked> asked_;
    std::vector<Cache> caches_;
    bool verdict_alone_ = false;
};

/// For PeerInfo::make.
template <class Library>
PeerBench* make_bench() {
    return new PeerBenchFor<Library>();
}

}  // namespace edgewise::peers
