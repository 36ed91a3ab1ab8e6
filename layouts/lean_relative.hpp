// SPDX-License-Identifier: MIT
//
// The table of `lean` with neighbours in one byte each: vertices are numbered by reverse Cuthill-McKee, and a
// ring's entry is the difference to the vertex's own number. 10.7 bytes per edge in double and 6.7 in single,
// for bodies of 45 to some 3 800 vertices, where `lean` takes 12.7 and 8.7 from 257 on; and a vertex and its
// neighbours lie on fewer lines.
//
// Answers are those of `lean` on the body in this order, to the bit. The order is the table's own. The body
// that it was built from knows each vertex's index in the user's list; so does the table itself if it keeps
// the permutation (InputOrder::kept), in 0.3 or 0.7 bytes per edge more.
#pragma once

#include <string_view>

#include "edgewise/layout_parts/relative_table.hpp"
#include "edgewise/layouts/lean.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class lean_relative : public RelativeTable<PlainPoints<typename P::Stored>, P, Loader> {
    using Base = RelativeTable<PlainPoints<typename P::Stored>, P, Loader>;

  public:
    static constexpr std::string_view name = "lean_relative";
    static constexpr std::string_view stores =
        "vertex coordinates, and neighbours as differences of 8 bits in an order of small bandwidth";

    using Base::Base;
};

}  // namespace edgewise
