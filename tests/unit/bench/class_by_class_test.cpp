// SPDX-License-Identifier: MIT
//
// Queries class by class: the same ones, every pair's in time order, and no more changes of class than where
// a pair comes again.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "edgewise/bench/prepared_workload.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::bench {
namespace {

/// Returns `frames` frames of `pairs` queries each; the x of each pose is the number of its query.
scene::Workload frames_of_pairs(scene::Rng& rng, std::uint32_t pairs, int frames, bool warm,
                                std::vector<std::uint8_t>& in_contact) {
    scene::Workload workload;
    workload.pair_count = warm ? pairs : pairs * static_cast<std::uint32_t>(frames);
    workload.warm = warm;
    for (int frame = 0; frame < frames; ++frame) {
        for (std::uint32_t pair = 0; pair < pairs; ++pair) {
            const auto number = static_cast<std::uint32_t>(workload.queries.size());
            Pose pose;
            pose.translation.x() = number;
            workload.queries.push_back({0, 0, warm ? pair : number, pose, {}});
            in_contact.push_back(rng.uniform() < 0.2);
        }
    }
    return workload;
}

std::size_t stretches(const std::vector<std::uint8_t>& in_contact) {
    std::size_t count = 1;
    for (std::size_t i = 1; i < in_contact.size(); ++i) count += in_contact[i] != in_contact[i - 1];
    return count;
}

void expect_same_queries(const scene::Workload& given, const std::vector<std::uint8_t>& in_contact,
                         const ClassByClass& sorted) {
    std::map<std::uint32_t, double> last_of_pair;
    std::vector<int> asked(given.queries.size(), 0);
    for (std::size_t i = 0; i < sorted.workload.queries.size(); ++i) {
        const scene::Query& query = sorted.workload.queries[i];
        const double number = query.pose_a.translation.x();
        const auto place = static_cast<std::size_t>(number);
        ++asked[place];
        EXPECT_EQ(query.pair, given.queries[place].pair);
        EXPECT_EQ(sorted.in_contact[i], in_contact[place]);
        const auto [last, is_first] = last_of_pair.try_emplace(query.pair, number);
        EXPECT_TRUE(is_first || last->second < number) << "a pair's queries stay in time order";
        last->second = number;
    }
    EXPECT_EQ(std::count(asked.begin(), asked.end(), 1), static_cast<std::ptrdiff_t>(asked.size()));
}

TEST(ClassByClass, KeepsEveryPairsOrderAndHasTwoStretchesAFrame) {
    scene::Rng rng(5);
    for (const std::uint32_t pairs : {1U, 7U, 100U}) {
        for (const bool warm : {true, false}) {
            std::vector<std::uint8_t> in_contact;
            const scene::Workload given = frames_of_pairs(rng, pairs, 20, warm, in_contact);
            const ClassByClass sorted(given, in_contact);
            expect_same_queries(given, in_contact, sorted);
            EXPECT_EQ(sorted.workload.warm, warm);
            EXPECT_EQ(sorted.workload.pair_count, given.pair_count);
            EXPECT_LE(stretches(sorted.in_contact), warm ? 40U : 2U);
        }
    }
}

}  // namespace
}  // namespace edgewise::bench
