// SPDX-License-Identifier: MIT
//
// Compares proofs in double with exact arithmetic, on pairs of every family of a campaign: every proved
// statement is true, and nearly every statement is proved.
#include "edgewise/truth/filter/float_proof.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "edgewise/scene/rng.hpp"
#include "edgewise/studies/campaign/pair_source.hpp"
#include "edgewise/truth/checked_answer.hpp"
#include "edgewise/truth/exact_proof.hpp"

namespace edgewise::studies::campaign {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t seed = 7;

struct Seen {
    int pairs = 0, in_double = 0, wide = 0, unknown = 0;
    int separated = 0, touching = 0, overlapping = 0, grazing = 0;

    void add(const Seen& other) {
        pairs += other.pairs;
        in_double += other.in_double;
        wide += other.wide;
        unknown += other.unknown;
        separated += other.separated;
        touching += other.touching;
        overlapping += other.overlapping;
        grazing += other.grazing;
    }
};

/// The exact distance is the double nearest to the truth, which may be a half step to either side.
void expect_true(const truth::FloatProof& proof, const truth::ExactDistance& exact, double band,
                 double depth) {
    EXPECT_LE(proof.lower, std::nextafter(exact.distance, infinity));
    EXPECT_GE(proof.upper, std::nextafter(exact.distance, -infinity));
    if (proof.verdict == truth::FloatVerdict::separated) {
        EXPECT_EQ(exact.verdict, truth::ExactVerdict::separated);
    }
    if (proof.verdict == truth::FloatVerdict::overlapping) {
        EXPECT_EQ(exact.verdict, truth::ExactVerdict::overlapping);
        EXPECT_EQ(proof.upper, 0);
    }
    EXPECT_GE(proof.most_depth, std::nextafter(depth, -infinity));
    if (proof.verdict == truth::FloatVerdict::grazing) {
        EXPECT_LE(exact.distance, band);
        EXPECT_LE(depth, band);
    }
}

double band_of(const Block& block, const std::pair<Pose, Pose>& poses) {
    return truth::accuracy_band(block.a.vertices, poses.first, block.b.vertices, poses.second,
                                std::numeric_limits<double>::epsilon())
        .band;
}

/// 0 of separated bodies, and of large ones, for which it is not asked: exact depths of some hundred vertices
/// take milliseconds.
double depth_of(const Block& block, const std::pair<Pose, Pose>& poses, const truth::ExactDistance& exact) {
    if (exact.verdict != truth::ExactVerdict::overlapping) return 0;
    if (block.a.vertex_count() > 100) return 0;
    return truth::exact_depth(block.a.vertices, poses.first, block.b.vertices, poses.second, exact.simplex)
        ->depth;
}

/// Returns a first guess of the separation: zero, the answer, the answer with a small error, or random.
Vec3d guess(const truth::ExactDistance& exact, scene::Rng& rng) {
    switch (rng.below(4)) {
        case 0:
            return Vec3d::Zero();
        case 1:
            return -exact.separation;
        case 2:
            return -exact.separation + norm(exact.separation) * 0x1p-20 * rng.on_sphere();
        default:
            return rng.on_sphere();
    }
}

Seen compare(const Block& block, scene::Rng& rng) {
    Seen seen;
    truth::ScannedBody a(block.a.vertices), b(block.b.vertices);
    for (const auto& poses : block.poses) {
        const auto exact =
            truth::exact_distance(block.a.vertices, poses.first, block.b.vertices, poses.second);
        const double band = band_of(block, poses);
        const truth::FloatProof proof =
            truth::prove_distance(a, poses.first, b, poses.second, guess(*exact, rng), band);
        expect_true(proof, *exact, band, depth_of(block, poses, *exact));
        const bool known = proof.verdict != truth::FloatVerdict::unknown;
        ++seen.pairs;
        seen.in_double += known && !proof.is_wide;
        seen.wide += known && proof.is_wide;
        seen.unknown += !known;
        seen.grazing += proof.verdict == truth::FloatVerdict::grazing;
        seen.separated += exact->verdict == truth::ExactVerdict::separated;
        seen.touching += exact->verdict == truth::ExactVerdict::touching;
        seen.overlapping += exact->verdict == truth::ExactVerdict::overlapping;
    }
    return seen;
}

TEST(FloatProof, SaysNothingFalseOfAnyFamily) {
    const PairSource source(seed, {}, {"tetra4", "cube8", "sphere38", "sphere386"});
    scene::Rng rng(seed);
    Seen all;
    std::map<std::string, Seen> families;
    for (std::uint64_t block = 0; block < 6 * source.families().size(); ++block) {
        const Block made = source.block(block, 128);
        if (!made.refusal.empty()) continue;
        SCOPED_TRACE(made.family + ", block " + std::to_string(block));
        const Seen seen = compare(made, rng);
        all.add(seen);
        families[made.family].add(seen);
    }
    for (const auto& [name, seen] : families)
        std::printf("%-24s %5d pairs: %5d proven in double, %4d wide, %4d not\n", name.c_str(), seen.pairs,
                    seen.in_double, seen.wide, seen.unknown);
    std::printf(
        "all: %d pairs, %d in double, %d wide, %d not; %d separated, %d touching, %d overlapping; %d proven grazing\n",
        all.pairs, all.in_double, all.wide, all.unknown, all.separated, all.touching, all.overlapping,
        all.grazing);
    EXPECT_GT(all.pairs, 20'000);
    for (const int regime :
         {all.in_double, all.wide, all.unknown, all.separated, all.touching, all.overlapping, all.grazing})
        EXPECT_GT(regime, 100);
    EXPECT_EQ(families.size(), source.families().size());
}

TEST(FloatProof, KnowsNearlyEveryRandomPair) {
    const PairSource source(seed, {"random"}, {"cube8", "sphere386"});
    for (std::uint64_t block = 0; block < 2; ++block) {
        const Block made = source.block(block, 2048);
        truth::StoredPair stored(made.a.vertices, made.b.vertices);
        int exact = 0;
        for (const auto& poses : made.poses)
            exact += stored.know(poses, Vec3d::Zero()).by == truth::KnownBy::exact;
        std::printf("%s: exact arithmetic for %d of 2048\n", made.family.c_str(), exact);
        EXPECT_LT(exact, 2048 / 20);
    }
}

TEST(FloatProof, ProvesNothingOfLengthsThatItCannotMultiply) {
    for (const double size : {0x1p-120, 0x1p120, 0x1p-1060, 0x1p900}) {
        const std::vector<Vec3d> a = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
        truth::ScannedBody scanned(a), same(a);
        const Pose here, there{Mat3d::Identity(), Vec3d(0, 0, size)};
        const truth::FloatProof proof =
            truth::prove_distance(scanned, here, same, there, Vec3d(0, 0, 1), size);
        EXPECT_EQ(proof.verdict, truth::FloatVerdict::unknown) << size;
        EXPECT_EQ(proof.lower, 0) << size;
        EXPECT_EQ(proof.upper, infinity) << size;
    }
}

}  // namespace
}  // namespace edgewise::studies::campaign
