// SPDX-License-Identifier: MIT
//
// The sub-distance of a search in singles (single_search.hpp), without a search of subsets. The closest point
// is known to rest on the newest point p. With the sides e_i = q_i - p to up to three older points, one line
// of arithmetic gives the weights on all edges p q_i and all faces p q_i q_i+1, and their signs say which of
// these carries it (Voronoi regions: Ericson, Real-Time Collision Detection, 2005, 5.1). A place without a
// point has e_i = 0, which passes no test.
//
// Three numbers, one for each older point, are the lanes of one register (Four: one query) or three registers
// (Three: a query in each lane). Both are the same formulas in the same order: the same bits.
#pragma once

#include "edgewise/algorithms/search/lane_vector.hpp"

namespace edgewise {

using Four = Numbers<4>;
using FourWords = Masks<4>;

/// Of the older point i, the value of point i + 1, and of point i - 1.
[[nodiscard, gnu::always_inline]] inline Four next(const Four& of) {
    return __builtin_shufflevector(of, of, 1, 2, 0, 3);
}
[[nodiscard, gnu::always_inline]] inline Four last(const Four& of) {
    return __builtin_shufflevector(of, of, 2, 0, 1, 3);
}
[[nodiscard, gnu::always_inline]] inline FourWords last(const FourWords& of) {
    return __builtin_shufflevector(of, of, 2, 0, 1, 3);
}
[[nodiscard, gnu::always_inline]] inline FourWords above_zero(const Four& of) { return of > 0; }
/// False where b is 0.
template <class Number>
[[nodiscard, gnu::always_inline]] inline auto have_opposite_signs(const Number& a, const Number& b) {
    using Mask = decltype(a > 0);
    return (((Mask)a ^ (Mask)b) >> 31) & (b != 0);
}

/// Zero where the mask is not set.
template <class Mask, class Number>
[[nodiscard, gnu::always_inline]] inline Number masked(const Mask& mask, const Number& of) {
    return (Number)(mask & (Mask)of);
}
[[nodiscard, gnu::always_inline]] inline Four either(const Four& a, const Four& b) {
    return (Four)((FourWords)a | (FourWords)b);
}

template <class Number>
struct Three {
    Number of[3];

    template <class Make>
    [[nodiscard, gnu::always_inline]] static Three make(const Make& make) {
        return {{make(0), make(1), make(2)}};
    }
    [[gnu::always_inline]] friend Three operator+(const Three& a, const Three& b) {
        return {{a.of[0] + b.of[0], a.of[1] + b.of[1], a.of[2] + b.of[2]}};
    }
    [[gnu::always_inline]] friend Three operator-(const Three& a, const Three& b) {
        return {{a.of[0] - b.of[0], a.of[1] - b.of[1], a.of[2] - b.of[2]}};
    }
    [[gnu::always_inline]] friend Three operator*(const Three& a, const Three& b) {
        return {{a.of[0] * b.of[0], a.of[1] * b.of[1], a.of[2] * b.of[2]}};
    }
    [[gnu::always_inline]] friend Three operator-(const Three& a) { return {{-a.of[0], -a.of[1], -a.of[2]}}; }
    [[gnu::always_inline]] friend Three operator&(const Three& a, const Three& b) {
        return {{a.of[0] & b.of[0], a.of[1] & b.of[1], a.of[2] & b.of[2]}};
    }
    [[gnu::always_inline]] friend Three operator|(const Three& a, const Three& b) {
        return {{a.of[0] | b.of[0], a.of[1] | b.of[1], a.of[2] | b.of[2]}};
    }
    [[gnu::always_inline]] friend Three operator~(const Three& a) { return {{~a.of[0], ~a.of[1], ~a.of[2]}}; }
};
template <class Number>
[[nodiscard, gnu::always_inline]] inline Three<Number> next(const Three<Number>& a) {
    return {{a.of[1], a.of[2], a.of[0]}};
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline Three<Number> last(const Three<Number>& a) {
    return {{a.of[2], a.of[0], a.of[1]}};
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline auto above_zero(const Three<Number>& a) {
    return Three<decltype(a.of[0] > 0)>{{a.of[0] > 0, a.of[1] > 0, a.of[2] > 0}};
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline auto have_opposite_signs(const Three<Number>& a,
                                                                  const Three<Number>& b) {
    return Three<decltype(a.of[0] > 0)>{{have_opposite_signs(a.of[0], b.of[0]),
                                         have_opposite_signs(a.of[1], b.of[1]),
                                         have_opposite_signs(a.of[2], b.of[2])}};
}
template <class Mask, class Number>
[[nodiscard, gnu::always_inline]] inline Three<Number> masked(const Three<Mask>& mask,
                                                              const Three<Number>& a) {
    return {{masked(mask.of[0], a.of[0]), masked(mask.of[1], a.of[1]), masked(mask.of[2], a.of[2])}};
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline Three<Number> either(const Three<Number>& a,
                                                              const Three<Number>& b) {
    using Mask = decltype(a.of[0] > 0);
    return Three<Number>::make([&](int i) __attribute__((always_inline)) {
        return (Number)((Mask)a.of[i] | (Mask)b.of[i]);
    });
}

/// A vector for each older point.
template <class Of>
struct OfOlder {
    Of x, y, z;
};
template <class Of>
[[nodiscard, gnu::always_inline]] inline Of dot(const OfOlder<Of>& a, const OfOlder<Of>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The sides from the newest point to the older ones, and what their products say. Of: Four, or Three.
template <class Of>
struct Sides {
    using Mask = decltype(above_zero(Of{}));

    OfOlder<Of> p, e;
    Of g, r;          ///< edge i: weight r_i over g_i
    Of l, m, det;     ///< face i: weights of q_i and of q_i+1, over det_i
    Mask ahead;       ///< edge i leads towards the origin
    Mask inside;      ///< the origin lies on the fourth point's side of face i; only where there are three
    Mask face, edge;  ///< the closest point rests on face i, or edge i

    [[gnu::always_inline]] Sides(const OfOlder<Of>& newest, const OfOlder<Of>& q, const Mask& held)
        : p(newest), e{masked(held, q.x - p.x), masked(held, q.y - p.y), masked(held, q.z - p.z)} {
        const OfOlder<Of> f = {next(e.x), next(e.y), next(e.z)};
        g = dot(e, e);
        const Of h = dot(e, f), next_g = next(g), s = dot(e, p), next_s = next(s);
        r = -s;
        l = next_s * h - s * next_g;
        m = s * h - next_s * g;
        det = g * next_g - h * h;
        const OfOlder<Of> normal = {e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x};
        const Of volume = dot(normal, OfOlder<Of>{last(e.x), last(e.y), last(e.z)});
        inside = have_opposite_signs(dot(normal, p), volume);
        ahead = above_zero(r);
        const Mask towards = above_zero(l), towards_next = above_zero(m);
        face = towards & towards_next & ~inside;
        edge = ahead & ~towards_next & ~last(towards);
    }

    /// The older points that the closest point rests on.
    [[nodiscard, gnu::always_inline]] Mask members() const { return face | last(face) | edge; }
    /// Their weights, times scale().
    [[nodiscard, gnu::always_inline]] Of weight() const {
        return either(either(masked(face, l), last(masked(face, m))), masked(edge, r));
    }
    /// In one of three: what the weights are to be divided by.
    [[nodiscard, gnu::always_inline]] Of scale() const { return either(masked(face, det), masked(edge, g)); }
};

/// The simplex of a search that signs do not decide: the nearest of all candidates.
struct NearestOfAll {
    Four weight;
    FourWords members;
    float scale;
};
[[nodiscard]] NearestOfAll try_all_sides(Four newest, OfOlder<Four> older, FourWords held);

}  // namespace edgewise
