// SPDX-License-Identifier: MIT
//
// FCL by libccd (GST_LIBCCD), its default. It offers no start for distances: every query is cold.
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include "edgewise/peers/adapters/fcl.hpp"

// Ours, with this module's flags, as fcl_indep.cpp says.
template class fcl::detail::GJKInitializer<double, fcl::Convex<double>>;

namespace edgewise::peers {

namespace {

struct FclLibccd {
    static constexpr const char* name = "fcl_libccd";
    static constexpr const char* precision = "f64";
    static constexpr const char* summary =
        "GJKSolver_libccd::shapeDistance on Convex; verdicts by shapeIntersect";
    static constexpr const char* cache = "nothing";

    using Shape = FclShape;
    using Placed = FclPlaced;
    struct Cache {};

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b, Cache&,
                            bool verdict_alone) {
        static const fcl::detail::GJKSolver_libccd<double> solver;
        if (!verdict_alone) return ask_fcl(solver, a, at_a, b, at_b);
        return {.separated =
                    !solver.shapeIntersect(a.convex, at_a.transform, b.convex, at_b.transform, nullptr)};
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<FclLibccd>; }

}  // namespace edgewise::peers
