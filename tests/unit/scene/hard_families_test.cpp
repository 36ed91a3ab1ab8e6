// SPDX-License-Identifier: MIT
//
// The hard families: the same cases from the same seed, every regime that a family names is there, and what
// the placing promises holds by exact arithmetic.
#include <gmock/gmock.h>

#include <cstdio>
#include <set>

#include "edgewise/scene/hard/families.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::scene {
namespace {

std::vector<Polyhedron> some_bodies() { return {*make_shape("cube8"), *make_shape("sphere38")}; }

const HardFamily& family(const std::string& name) {
    for (const HardFamily& candidate : hard_families()) {
        if (candidate.name == name) return candidate;
    }
    throw std::logic_error(name);
}

bool same(const hard::Pair& p, const hard::Pair& q) {
    bool equal =
        p.a.vertices == q.a.vertices && p.b.vertices == q.b.vertices && p.poses.size() == q.poses.size();
    for (std::size_t i = 0; equal && i < p.poses.size(); ++i) {
        equal = p.poses[i].second.rotation == q.poses[i].second.rotation &&
                p.poses[i].second.translation == q.poses[i].second.translation;
    }
    return equal;
}

struct Verdicts {
    int separated = 0, contact = 0;
};

Verdicts verdicts_of(const HardFamily& of, int count) {
    const auto bodies = some_bodies();
    hard::Maker maker(7, false, bodies);
    Verdicts seen;
    for (int i = 0; i < count; ++i) {
        const hard::Pair pair = of.make(maker);
        for (const auto& [pose_a, pose_b] : pair.poses) {
            const auto exact = truth::exact_distance(pair.a.vertices, pose_a, pair.b.vertices, pose_b);
            EXPECT_TRUE(exact) << of.name << ": " << exact.error;
            ++(exact->verdict == truth::ExactVerdict::separated ? seen.separated : seen.contact);
        }
    }
    return seen;
}

TEST(HardFamilies, AreThoseOfTheListAndTheSixRows) {
    std::set<std::string> names;
    for (const HardFamily& of : hard_families()) names.insert(of.name);
    EXPECT_EQ(names.size(), 31U);
}

TEST(HardFamilies, OneSeedOneSetOfCases) {
    const auto bodies = some_bodies();
    for (const HardFamily& of : hard_families()) {
        hard::Maker maker(3, false, bodies), again(3, false, bodies), other(4, false, bodies);
        bool differs = false;
        for (int i = 0; i < 20; ++i) {
            const hard::Pair pair = of.make(maker);
            EXPECT_TRUE(same(pair, of.make(again))) << of.name;
            differs |= !same(pair, of.make(other));
        }
        EXPECT_TRUE(differs) << of.name;
    }
}

TEST(HardFamilies, HoldBothSeparatedPairsAndContacts) {
    const std::set<std::string> only_contact = {"exact_touch", "deep_and_concentric", "cubes_identical_pose"};
    for (const HardFamily& of : hard_families()) {
        const Verdicts seen = verdicts_of(of, of.warm ? 6 : 100);
        std::printf("%-24s %4d separated, %4d in contact\n", of.name.c_str(), seen.separated, seen.contact);
        if (of.name != "far_apart") {
            EXPECT_GT(seen.contact, 0) << of.name;
        }
        if (!only_contact.contains(of.name)) {
            EXPECT_GT(seen.separated, 0) << of.name;
        }
    }
}

TEST(HardFamilies, TouchExactlyWhereTheySaySo) {
    hard::Maker maker(5, true, {});
    for (int i = 0; i < 300; ++i) {
        const hard::Pair pair = family("exact_touch").make(maker);
        const auto& [pose_a, pose_b] = pair.poses.front();
        const auto exact = truth::exact_distance(pair.a.vertices, pose_a, pair.b.vertices, pose_b);
        EXPECT_EQ(exact->verdict, truth::ExactVerdict::touching) << i;
    }
}

TEST(HardFamilies, QuarterTurnsAreRotationsOfTheCube) {
    hard::Maker maker(6, false, {});
    std::set<std::string> seen;
    for (int i = 0; i < 2000; ++i) {
        const Mat3d turn = maker.quarter_turn();
        EXPECT_EQ(dot(turn.col(0), cross(Vec3d(turn.col(1)), Vec3d(turn.col(2)))), 1);
        std::string text;
        for (int k = 0; k < 9; ++k) text += static_cast<char>('1' + static_cast<int>(turn(k / 3, k % 3)));
        seen.insert(text);
    }
    EXPECT_EQ(seen.size(), 24U);
}

}  // namespace
}  // namespace edgewise::scene
