// SPDX-License-Identifier: MIT
//
// FCL's own GJK (GST_INDEP), with the direction that it caches.
#include <fcl/narrowphase/detail/gjk_solver_indep.h>

#include "edgewise/peers/adapters/fcl.hpp"

// The library's own instantiations are compiled for any processor, and several times slower. We instantiate
// the same headers with this module's flags.
template struct fcl::detail::GJK<double>;
template struct fcl::detail::MinkowskiDiff<double>;

namespace edgewise::peers {

namespace {

struct FclIndep {
    static constexpr const char* name = "fcl_indep";
    static constexpr const char* precision = "f64";
    static constexpr const char* summary = "GJKSolver_indep::shapeDistance on Convex";
    static constexpr const char* cache = "the solver, with its last direction";

    using Shape = FclShape;
    using Placed = FclPlaced;
    /// The solver is the cache: it is asked to keep its last direction.
    struct Cache {
        fcl::detail::GJKSolver_indep<double> solver;
    };

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b,
                            Cache& cache, bool) {
        cache.solver.enable_cached_guess = true;
        return ask_fcl(cache.solver, a, at_a, b, at_b);
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<FclIndep>; }

}  // namespace edgewise::peers
