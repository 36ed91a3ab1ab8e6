// SPDX-License-Identifier: MIT
//
// Structure of arrays: the same scalars as `aos`, each in an array of its own: twenty for an edge, three for
// a vertex, four for a face. Made for passes over all edges; V-Clip jumps from edge to edge, and pays a cache
// line a scalar. More parallel arrays than a cache has ways is a trap of its own.
#pragma once

#include "edgewise/layout_parts/scalar_arrays.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class soa : public ScalarArrays<P, Loader, Spacing::back_to_back> {
    using Base = ScalarArrays<P, Loader, Spacing::back_to_back>;

  public:
    static constexpr std::string_view name = "soa";
    static constexpr std::string_view stores = "the scalars of aos, each in an array of its own";
    static constexpr std::string_view derives = "nothing";

    soa(const Polyhedron& body, Parts parts, Loader loader = {}, WriteEdges write = WriteEdges::now)
        : Base(body, parts, loader, write) {}

    /// The same memory seen through another loader.
    template <class OtherLoader>
    soa(const soa<P, OtherLoader>& other, Loader loader) : Base(other, loader) {}
};

}  // namespace edgewise
