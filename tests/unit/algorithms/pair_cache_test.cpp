// SPDX-License-Identifier: MIT
//
// Contents of a pair: as few bytes as promised, the handles that were put in, and nothing that does not fit.
#include <gtest/gtest.h>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/linked.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise {
namespace {

/// The corners of a tetrahedron, with handles that begin anywhere.
struct FarHandles {
    using PrecisionType = f64;
    using Vertex = std::uint32_t;
    Vertex first;

    [[nodiscard]] Vertex first_vertex() const { return first; }
    [[nodiscard]] Vec3d vertex(Vertex v) const {
        const Vertex i = v - first;
        return {i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0, i == 3 ? 1.0 : 0.0};
    }
    [[nodiscard]] std::vector<Vertex> all_vertices() const {
        return {first, first + 1, first + 2, first + 3};
    }
};

using FarPair = SimplexPair<FarHandles, FarHandles>;

TEST(PairCache, TakesFewBytes) {
    EXPECT_EQ(sizeof(SimplexPair<aos<f64>, aos<f64>>), 32U);
    EXPECT_EQ(sizeof(SimplexPair<lean<f32>, lean<f32>>), 32U);
    EXPECT_EQ(sizeof(FeaturePair<aos<f64>, aos<f64>>), 8U);
    EXPECT_EQ(sizeof(FeaturePair<lean<f32>, lean<f32>>), 8U);
    EXPECT_EQ(sizeof(FeaturePair<linked<f64>, linked<f64>>), 40U)
        << "two addresses, each with its note, and a flag";
}

TEST(PairCache, HoldsWhatWasPutIn) {
    scene::Rng rng(5);
    for (int i = 0; i < 1000; ++i) {
        const FarHandles a{static_cast<Index>(rng.below(1U << 24))},
            b{static_cast<Index>(rng.below(1U << 24))};
        FarPair pair(a, b);
        const auto count = static_cast<std::uint32_t>(rng.below(5));
        std::vector<FarPair::Corner> corners;
        for (std::uint32_t k = 0; k < count; ++k) {
            corners.push_back(
                {static_cast<Index>(rng.below(1U << 24)), static_cast<Index>(rng.below(1U << 24))});
            pair.push(corners.back());
        }
        ASSERT_EQ(pair.count(), count);
        EXPECT_TRUE(pair.belongs_to(a, b));
        for (std::uint32_t k = 0; k < count; ++k) EXPECT_EQ(pair.corner(k), corners[k]);
        EXPECT_TRUE(std::isinf(pair.distance())) << "nobody said how far";
    }
}

/// Handles up to 24 bits are kept, larger ones are not: such a pair is asked cold each time, and answered.
TEST(PairCache, KeepsNoHandleThatDoesNotFit) {
    const Transform<double> pose{Mat3d::Identity(), {3, 0, 0}};
    for (const auto& [first, fits] :
         {std::pair{(1U << 24) - 4, true}, {1U << 24, false}, {1U << 31, false}}) {
        const FarHandles shape{first};
        FarPair pair(shape, shape);
        for (int frame = 0; frame < 3; ++frame) {
            const Distance answer = Gjk::query(shape, shape, pose, pair);
            EXPECT_EQ(answer.distance, 2);
            EXPECT_TRUE(pair.belongs_to(shape, shape));
            EXPECT_EQ(pair.starts_warm(shape, shape), fits);
        }
    }
}

}  // namespace
}  // namespace edgewise
