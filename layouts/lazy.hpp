// SPDX-License-Identifier: MIT
//
// The table of `hot_cold`, with the planes of an edge made when a query first asks for one
// (layout_parts/lazy.hpp). What V-Clip never walks over is never worked out, and as planes lie apart from
// what every edge has, pages that hold only such planes are never touched. The canonical body must stay at
// hand.
#pragma once

#include "edgewise/layout_parts/hot_cold_table.hpp"
#include "edgewise/layout_parts/lazy.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class lazy : public Lazy<HotColdTable<P, Loader>, Loader> {
    using Base = Lazy<HotColdTable<P, Loader>, Loader>;

  public:
    static constexpr std::string_view name = "lazy";
    static constexpr std::string_view stores =
        "as hot_cold, an edge's planes from when they are first asked for; the body must stay at hand";
    static constexpr std::string_view derives = "an edge's planes, once";

    lazy(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(body, parts, loader) {}

    /// The same memory seen through another loader.
    template <class OtherLoader>
    lazy(const lazy<P, OtherLoader>& other, Loader loader) : Base(other, loader) {}
};

}  // namespace edgewise
