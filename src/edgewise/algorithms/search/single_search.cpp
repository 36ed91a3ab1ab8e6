// SPDX-License-Identifier: MIT
#include "edgewise/algorithms/search/single_search.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "edgewise/algorithms/search/lane_bodies.hpp"
#include "edgewise/algorithms/search/lane_search.hpp"
#include "edgewise/algorithms/search/sides.hpp"

namespace edgewise {

namespace {

/// The bits of the first three lanes in one word.
[[nodiscard, gnu::always_inline]] inline unsigned bits_of(const FourWords& of) {
    const FourWords both = of | __builtin_shufflevector(of, of, 2, 3, 2, 3);
    return static_cast<unsigned>((both | __builtin_shufflevector(of, of, 1, 1, 1, 1))[0]);
}
template <int lane>
[[nodiscard, gnu::always_inline]] inline Four all(const Four& of) {
    return __builtin_shufflevector(of, of, lane, lane, lane, lane);
}
[[nodiscard, gnu::always_inline]] inline float sum_of_three(const Four& of) { return of[0] + of[1] + of[2]; }

/// The simplex of one search: up to three points, in the lanes and as they were added.
struct SingleSimplex {
    OfOlder<Four> q{};
    FourWords pairs{}, held{};
    Four v{};  ///< its closest point, times scale
    float scale = 1;

    [[gnu::always_inline]] void insert(const Four& p, std::int32_t pair, Four* corner) {
        alignas(16) static constexpr std::int32_t masks[4][4] = {
            {-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}, {}};
        const auto free = std::countr_one(bits_of(held & FourWords{1, 2, 4, 0}));
        const auto& mask = reinterpret_cast<const FourWords&>(masks[free]);
        q.x = either(masked(mask, all<0>(p)), masked(~mask, q.x));
        q.y = either(masked(mask, all<1>(p)), masked(~mask, q.y));
        q.z = either(masked(mask, all<2>(p)), masked(~mask, q.z));
        pairs = (mask & (FourWords{} + pair)) | (~mask & pairs);
        held |= mask;
        corner[free] = p;
    }

    /// Adds a point; false if it and the older ones surround the origin.
    [[nodiscard, gnu::always_inline]] bool add(const Four& p, std::int32_t pair, Four* corner) {
        const Sides<Four> sides({all<0>(p), all<1>(p), all<2>(p)}, q, held);
        const unsigned signs = bits_of(
            (sides.face & FourWords{1, 2, 4, 0}) | (sides.edge & FourWords{8, 16, 32, 0}) |
            (sides.inside & FourWords{64, 128, 256, 0}) | (sides.ahead & FourWords{512, 1024, 2048, 0}));
        if ((signs >> 6 & 7) == 7) return false;
        const unsigned chosen = signs & 63;
        Four weight = sides.weight(), scales = sides.scale();
        FourWords members = sides.members();
        if (chosen == 0 && signs >> 9 == 0) {
            scales = Four{1};
        } else if (!std::has_single_bit(chosen)) [[unlikely]] {
            const NearestOfAll nearest = try_all_sides(p, q, held);
            weight = nearest.weight;
            scales = Four{nearest.scale};
            members = nearest.members;
        }
        scales = either(scales, either(last(scales), next(scales)));
        scale = scales[0];
        v = (all<0>(scales) * p + all<0>(weight) * (corner[0] - p)) +
            (all<1>(weight) * (corner[1] - p) + all<2>(weight) * (corner[2] - p));
        held = members;
        insert(p, pair, corner);
        return true;
    }
};

template <int size>
[[gnu::always_inline]] inline void search(const SingleSearch& of, SingleSearchEnd& end) {
    SingleVertices b_in_a;
    Rows<size>::move_to_a(of, b_in_a);
    SingleSimplex simplex;
    Four corner[4] = {};
    simplex.v = Four{-of.towards_b.x(), -of.towards_b.y(), -of.towards_b.z(), 0};
    float least = std::numeric_limits<float>::infinity(), extent = 0;
    for (end.steps = 1; end.steps <= most_search_steps; ++end.steps) {
        const Four v = simplex.v;
        const std::int32_t a = Rows<size>::template farthest<false>(of.a, v),
                           b = Rows<size>::template farthest<true>(b_in_a, v);
        const auto i = static_cast<std::size_t>(a), k = static_cast<std::size_t>(b);
        const Four p = {of.a.x[i] - b_in_a.x[k], of.a.y[i] - b_in_a.y[k], of.a.z[i] - b_in_a.z[k], 0};
        const std::int32_t pair = a << 8 | b;
        if (end.steps == 1) {
            extent = std::max({std::abs(b_in_a.x[k]), std::abs(b_in_a.y[k]), std::abs(b_in_a.z[k])});
            simplex.v = p;
            simplex.insert(p, pair, corner);
            continue;
        }
        const float squared = sum_of_three(v * v), reach = sum_of_three(v * p) * simplex.scale,
                    root = simplex.scale * std::sqrt(squared), open = search_gap * extent * root,
                    length = squared / (simplex.scale * simplex.scale);
        const bool is_decided = squared - reach <= open || reach > clear_gaps * open + of.cutoff * root;
        if (is_decided || bits_of(simplex.held & (simplex.pairs == pair)) != 0 || !(length < least)) break;
        least = length;
        if (simplex.add(p, pair, corner)) continue;
        for (int point = 0; point < 3; ++point) end.add(simplex.pairs[point], true);
        return end.add(pair, true);
    }
    for (int point = 0; point < 3; ++point) end.add(simplex.pairs[point], simplex.held[point] != 0);
}

void search_128(const SingleSearch& of, SingleSearchEnd& end) { search<4>(of, end); }

#ifdef __x86_64__
/// Two bodies of one row each: halves of a row are joined faster than a whole one.
[[gnu::target("avx2")]] void search_256(const SingleSearch& of, SingleSearchEnd& end) {
    if (of.a.count + of.b.count == 2 * SingleVertices::row) return search<4>(of, end);
    search<8>(of, end);
}
[[gnu::target("avx2")]] void search_in_lanes(SearchSource& source) { LaneSearch(source).run(); }
#else
void search_256(const SingleSearch& of, SingleSearchEnd& end) { search_128(of, end); }
void search_in_lanes(SearchSource& source) { LaneSearch(source).run(); }
#endif

}  // namespace

NearestOfAll try_all_sides(Four newest, OfOlder<Four> older, FourWords held) {
    const Sides<Four> s({all<0>(newest), all<1>(newest), all<2>(newest)}, older, held);
    NearestOfAll nearest = {Four{}, FourWords{}, 1};
    float least = sum_of_three(newest * newest);
    const auto take = [&](const Four& weight, const FourWords& members, float scale) {
        const float x = scale * newest[0] + sum_of_three(weight * s.e.x),
                    y = scale * newest[1] + sum_of_three(weight * s.e.y),
                    z = scale * newest[2] + sum_of_three(weight * s.e.z),
                    squared = (x * x + y * y + z * z) / (scale * scale);
        if (!(squared < least)) return;
        least = squared;
        nearest = {weight, members, scale};
    };
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        Four weight{};
        FourWords members{};
        members[i] = -1;
        weight[i] = s.r[i];
        if (s.r[i] > 0 && s.r[i] < s.g[i]) take(weight, members, s.g[i]);
        members[j] = -1;
        weight[i] = s.l[i];
        weight[j] = s.m[i];
        if (s.l[i] > 0 && s.m[i] > 0 && s.l[i] + s.m[i] < s.det[i]) take(weight, members, s.det[i]);
    }
    return nearest;
}

bool has_lanes() {
#ifdef __x86_64__
    return __builtin_cpu_supports("avx2");
#else
    return false;
#endif
}

void run_single_search(const SingleSearch& search, SingleSearchEnd& end) {
    static const bool is_wide = has_lanes();
    is_wide ? search_256(search, end) : search_128(search, end);
}

void run_lane_searches(SearchSource& source) {
    assert(has_lanes());
    search_in_lanes(source);
}

}  // namespace edgewise
