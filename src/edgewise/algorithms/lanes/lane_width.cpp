// SPDX-License-Identifier: MIT
#include "edgewise/algorithms/lanes/lane_width.hpp"

#include <cassert>

#include "edgewise/algorithms/lanes/lane_gjk.hpp"

namespace edgewise {

namespace {

template <class Scalar>
void run_128(LaneSource<Scalar>& source, const QueryOptions& options) {
    LaneGjk<Scalar, 16 / sizeof(Scalar)>(source, options).run();
}

#ifdef __x86_64__
template <class Scalar>
[[gnu::target("avx2")]] void run_256(LaneSource<Scalar>& source, const QueryOptions& options) {
    LaneGjk<Scalar, 32 / sizeof(Scalar)>(source, options).run();
}
#else
template <class Scalar>
void run_256(LaneSource<Scalar>& source, const QueryOptions& options) {
    run_128(source, options);
}
#endif

template <class Scalar>
void run_at(LaneSource<Scalar>& source, const QueryOptions& options, LaneWidth width) {
    assert(width != LaneWidth::none);
    width == LaneWidth::bits_256 ? run_256(source, options) : run_128(source, options);
}

}  // namespace

LaneWidth best_lanes() {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2")) return LaneWidth::bits_256;
#endif
    return LaneWidth::none;
}

void run_lanes(LaneSource<double>& source, const QueryOptions& options, LaneWidth width) {
    run_at(source, options, width);
}
void run_lanes(LaneSource<float>& source, const QueryOptions& options, LaneWidth width) {
    run_at(source, options, width);
}

}  // namespace edgewise
