// SPDX-License-Identifier: MIT
//
// A workload's queries as frames of batches: the same answers as one by one, in the bits of their sum,
// however many threads ask, and no pair twice in a frame.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "edgewise/bench/frame_batches.hpp"
#include "edgewise/bench/prepared_workload.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::bench {
namespace {

struct FramedScene {
    const char* kind;
    scene::SceneParameters parameters;
    bool is_one_frame;
};

const FramedScene framed_scenes[] = {{"cold", {}, true},
                                     {"tumble", {}, false},
                                     {"tumble", {{"in_time_order", 1}}, false},
                                     {"pressure", {{"bodies", 40}, {"new_order", 1}}, false}};

studies::SingleCell framed_cell(const FramedScene& scene, const char* table, const char* algorithm) {
    return studies::SingleCell({.table = table,
                                .algorithm = algorithm,
                                .scene = scene.kind,
                                .shape = "sphere18",
                                .parameters = scene.parameters});
}

TEST(FrameBatches, HaveTheSumOfSingleQueriesInAnyNumberOfThreads) {
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    for (const FramedScene& scene : framed_scenes) {
        for (const auto& [table, algorithm] : {std::pair{"lean_f64", "vclip"},
                                               {"lean_f32", "gjk"},
                                               {"linked_f64", "gjk"},
                                               {"aos_f64", "vclip"}}) {
            const studies::SingleCell cell = framed_cell(scene, table, algorithm);
            const std::size_t count = cell.workload().queries.size();
            const double expected = cell.runner().prepared_range()(0, count, nullptr);
            const auto frames = cell.runner().prepared_frames();
            ASSERT_TRUE(frames);
            for (const int threads : {1, 2, 4}) {
                frames->set_back();
                frames->run(threads);
                EXPECT_EQ(frames->sum(), expected) << scene.kind << ' ' << table << ' ' << threads;
            }
            EXPECT_GT(expected, 0);
            EXPECT_EQ(frames->frames() == 1, scene.is_one_frame) << frames->frames();
            if (scene.is_one_frame) continue;
            // Pairs go on where they were: other starts, so other last bits here and there.
            frames->run(2);
            std::printf("%s %s: %zu frames, sum %.17g, of pairs that go on %.17g\n", scene.kind, table,
                        frames->frames(), expected, frames->sum());
        }
    }
}

TEST(FrameBatches, AskNoPairTwiceInAFrameAndEachInItsOrder) {
    for (const FramedScene& scene : framed_scenes) {
        const studies::SingleCell cell = framed_cell(scene, "lean_f64", "gjk");
        const scene::Workload& workload = cell.workload();
        const FrameOrder order(workload);
        std::vector<std::size_t> last(workload.pair_count, 0);
        std::set<std::size_t> asked;
        std::size_t first = 0;
        for (const std::size_t end : order.ends) {
            std::set<std::uint32_t> pairs;
            for (; first < end; ++first) {
                const std::size_t i = order.numbers[first];
                EXPECT_TRUE(asked.insert(i).second);
                if (!workload.warm) continue;
                const std::uint32_t pair = workload.queries[i].pair;
                EXPECT_TRUE(pairs.insert(pair).second);
                EXPECT_GE(i + 1, last[pair]) << "in time order";
                last[pair] = i + 1;
            }
        }
        EXPECT_EQ(asked.size(), workload.queries.size());
    }
}

struct BatchedScene {
    const char *kind, *shape;
    scene::SceneParameters parameters;
};

struct Passed {
    std::vector<Distance> answers;
    double sum = 0;
};

Passed answers_of(const studies::SingleCell& cell, bool batch) {
    const auto runner = cell.type().make_runner(cell.algorithm());
    RunnerOptions options;
    options.batch = batch;
    runner->configure(options);
    EXPECT_EQ(runner->load(cell.workload()), "");
    const Runner::RangePass pass = runner->prepared_range();
    std::vector<Distance> answers(cell.workload().queries.size());
    double sum = 0;
    // Twice, and in two parts: pairs go on, and are set back.
    for (int i = 0; i < 2; ++i) {
        sum = pass(0, answers.size() / 3, answers.data());
        sum += pass(answers.size() / 3, answers.size(), answers.data());
    }
    return {answers, sum};
}

bool same_answer(const Distance& a, const Distance& b) {
    const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
    return a.status == b.status && a.steps == b.steps && same(a.distance, b.distance) &&
           same(a.point_a, b.point_a) && same(a.point_b, b.point_b) && same(a.normal, b.normal);
}

struct BatchTally {
    std::size_t asked = 0, separated = 0;
};

void expect_same_passes(const studies::SingleCell& cell, BatchTally& tally) {
    const auto [one, sum] = answers_of(cell, false);
    const auto [batch, sum_of_batches] = answers_of(cell, true);
    EXPECT_EQ(sum, sum_of_batches) << "to the bit: a cell fails if its passes differ";
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_TRUE(same_answer(one[i], batch[i])) << cell.type().name << ' ' << cell.algorithm() << ' ' << i;
        ++tally.asked;
        tally.separated += one[i].status == Status::separated;
    }
}

/// Independent queries, pairs that come again in every frame, and one pair many times in a row.
TEST(BatchPass, AnswersAsOneByOne) {
    const BatchedScene scenes[] = {{"cold", "cube8", {}},
                                   {"cold", "sphere38", {}},
                                   {"tumble", "cube8", {{"in_time_order", 1}, {"bodies", 30}}},
                                   {"tumble", "sphere8", {}}};
    for (const std::string algorithm : {"gjk", "vclip"}) {
        BatchTally tally;
        for (const BatchedScene& scene : scenes) {
            for (const std::string table : {"lean_f64", "lean_f32", "points_soa_f64", "linked_f64"}) {
                if (table == "points_soa_f64" && algorithm == "vclip") continue;  // vertices alone
                expect_same_passes(studies::SingleCell({.table = table,
                                                        .algorithm = algorithm,
                                                        .scene = scene.kind,
                                                        .shape = scene.shape,
                                                        .parameters = scene.parameters}),
                                   tally);
            }
        }
        EXPECT_GT(tally.separated, tally.asked / 4);
        EXPECT_LT(tally.separated, tally.asked);
        std::printf("%zu answers of %s's batches are those of single queries, %zu of them separated\n",
                    tally.asked, algorithm.c_str(), tally.separated);
    }
}

// Queries class by class: the same ones, every pair's in time order, and no more changes of class than where
// a pair comes again.

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
