// SPDX-License-Identifier: MIT
//
// Structure of arrays with staggered starts: the scalars of `soa`, each in an array of its own, but never at
// a distance that is a multiple of a cache's stride.
//
// A first-level cache of 32 KiB and 8 ways, or of 48 KiB and 12, has 64 sets: addresses that differ by a
// multiple of 64 sets * 64 bytes = 4096 bytes share a set. Back-to-back arrays that take a multiple of 4096
// bytes each in whole lines (505 to 512 edges in double, 1009 to 1024 in single, to begin with) put the
// twenty scalars of one edge into one set. The set keeps 8 or 12 of them, so a walk over the edges that needs
// all twenty misses on every read: tests/unit/table/stagger_test.cpp shows it. Of the built-in spheres
// sphere1538 is affected, with 576 lines an array in double. Lengths that share a factor with 4096 put half
// or a quarter of the scalars into one set. A fixed gap only moves the problem to another length. So the gap
// is none or one line, such that the distance from one array to the next is an odd number of lines. Multiples
// of an odd number repeat modulo 64 only after 64 of them, whatever the length, and modulo any larger power
// of two later still: twenty scalars, twenty sets. The gaps are padding: at most one line an array; all other
// bytes are those of `soa`.
#pragma once

#include <string_view>

#include "edgewise/layouts/soa.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class soa_stagger : public StoredTable<SoaArrays<typename P::Stored, Spacing::odd_lines>, P, Loader> {
    using Base = StoredTable<SoaArrays<typename P::Stored, Spacing::odd_lines>, P, Loader>;

  public:
    static constexpr std::string_view name = "soa_stagger";
    static constexpr std::string_view stores =
        "the arrays of soa, an odd number of cache lines from start to start";

    using Base::Base;
};

}  // namespace edgewise
