// SPDX-License-Identifier: MIT
//
// The bodies that tables are tested on, as a table stores them: rounded to single if it stores single.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bodies.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise {

/// True if planes are computed from corners on demand.
template <class T>
concept DerivesPlanes = requires {
    T::derives_planes;
};

template <class T>
inline constexpr bool has_features = FeatureTable<T>;
template <class T>
inline constexpr double compute_eps = std::numeric_limits<ComputeOf<T>>::epsilon();
/// Rounding step of the type that planes are rounded to.
template <class T>
inline constexpr double stored_eps =
    DerivesPlanes<T> ? compute_eps<T>
                     : double{std::numeric_limits<typename T::PrecisionType::Stored>::epsilon()};

/// Body that a table of this body holds.
template <class T>
[[nodiscard]] Polyhedron as_stored(const Polyhedron& body) {
    auto stored = stored_body<T>(body);
    EXPECT_TRUE(stored) << stored.error;
    return *stored;
}

/// Returns false, and prints why, if the layout takes no such bodies: its reason then begins with its name.
template <class T>
[[nodiscard]] bool holds(const Polyhedron& body) {
    const std::string why = stored_body<T>(body).error;
    if (!why.starts_with(std::string(T::name) + " takes bodies of ")) return true;
    std::printf("%s\n", why.c_str());
    return false;
}

/// The bodies given that the layout holds; of a layout that takes boxes alone, these.
template <class T>
[[nodiscard]] const std::vector<NamedBody>& test_bodies() {
    static const std::vector<NamedBody> bodies = [] {
        std::vector<NamedBody> given = given_bodies(), stored;
        std::erase_if(given, [](const NamedBody& named) { return !holds<T>(named.body); });
        if (given.size() < 5) std::ranges::move(boxes(), std::back_inserter(given));
        for (const auto& [name, body] : given) stored.push_back({name, as_stored<T>(body)});
        EXPECT_GE(stored.size(), 5U);
        return stored;
    }();
    return bodies;
}

/// Calls check(table, body, name) with a table of each test body; skips the test if the layout has no
/// features.
template <class T, class Check>
void for_each_feature_table(Check check) {
    if constexpr (has_features<T>) {
        for (const auto& [name, body] : test_bodies<T>()) {
            SCOPED_TRACE(name);
            check(T(body, Parts::features), body, name);
        }
    } else {
        GTEST_SKIP() << "this layout has no features";
    }
}

/// Index of a table's face in the body, found by the face's first edge.
template <class T>
[[nodiscard]] Index body_face(const T& table, const typename T::Face& f, const Polyhedron& body) {
    const auto [edge, flipped] = *table.ring_of_face(f).begin();
    const Index from = table.index_of(flipped ? table.head(edge) : table.tail(edge));
    const Index to = table.index_of(flipped ? table.tail(edge) : table.head(edge));
    for (const HalfEdge h : body.ring_of_vertex(from)) {
        if (body.head(h) == to) return body.face(h);
    }
    return no_face;
}

}  // namespace edgewise
