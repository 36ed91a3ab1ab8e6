// SPDX-License-Identifier: MIT
//
// Every case of the corpus through every table type and algorithm, as given, swapped, and with its vertices
// reversed. Exact arithmetic on the bodies that the tables hold checks verdicts outside the band, distance,
// witness points, depth, and the certificates of the stored and of the given bodies. The cases are also
// turned by quarter turns and moved, as far as that rounds no coordinate, and asked at other scales, where
// the answer must have the same bits.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "corpus.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "judged_case.hpp"

namespace edgewise {
namespace {

struct Worst {
    double distance = 0, witness = 0, depth = 0;  ///< over scale, beyond the band
    int apart = 0, contact = 0, in_band = 0;
    int refused = 0, not_held = 0;  ///< out of range of the storage; too large or no box for the layout
};

struct Subject {
    const bench::TableType& type;
    std::string algorithm;
};

void PrintTo(const Subject& subject, std::ostream* out) { *out << subject.type.name << subject.algorithm; }

class Corpus : public testing::TestWithParam<Subject> {
  protected:
    void SetUp() override { runner_ = GetParam().type.make_runner(GetParam().algorithm); }

    void expect_right(const scene::Case& given) {
        const JudgedCase judged = judge_case(*runner_, {GetParam().type.eps}, given);
        if (!judged.answered) {
            const bool not_its_kind = judged.refusal.find(" takes bodies of ") != std::string::npos;
            ++(not_its_kind ? worst_.not_held : worst_.refused);
            std::printf("%s: %s\n", given.id.c_str(), judged.refusal.c_str());
            return;
        }
        for (const std::string& complaint : judged.complaints) wrong_.push_back(given.id + ": " + complaint);
        ++(judged.apart ? worst_.apart : worst_.contact);
        worst_.in_band += judged.in_band;
        worst_.distance = std::max(worst_.distance, judged.distance);
        worst_.witness = std::max(worst_.witness, judged.witness);
        worst_.depth = std::max(worst_.depth, judged.depth);
    }

    void print(const char* how) const {
        std::printf(
            "%s %s%s: error %.2g, witness %.2g, depth %.2g; %d apart, %d in contact, %d in the band\n",
            GetParam().type.name.c_str(), GetParam().algorithm.c_str(), how, worst_.distance, worst_.witness,
            worst_.depth, worst_.apart, worst_.contact, worst_.in_band);
    }

    static bool holds_boxes_alone() { return GetParam().type.layout == "box"; }
    /// Number of cases that single precision cannot hold: `boxes` of them begin with a box.
    static int out_of_range(int all, int boxes) {
        return GetParam().type.storage == "single" ? all : GetParam().type.name == "box_f32" ? boxes : 0;
    }

    Worst worst_;
    std::vector<std::string> wrong_;
    std::unique_ptr<bench::Runner> runner_;
};

TEST_P(Corpus, IsAnsweredRightHoweverItIsGiven) {
    ASSERT_GE(corpus().size(), 180U);
    for (const scene::Case& given : corpus()) {
        expect_right(given);
        expect_right(swapped(given));
        expect_right(reversed(given));
    }
    print("");
    EXPECT_THAT(wrong_, testing::IsEmpty());
    // Two cases in their three forms are out of the range of single precision.
    EXPECT_EQ(worst_.refused, out_of_range(6, 4));
    EXPECT_GT(worst_.apart, holds_boxes_alone() ? 60 : 200);
    EXPECT_GT(worst_.contact, 200);
}

/// Turning and moving a case must not change its exact distance, on which the following test relies.
TEST(CorpusMotion, LeavesTheExactDistanceAsItIs) {
    for (const scene::Case& given : corpus()) {
        const auto exact = [&](const scene::Case& of) {
            return truth::exact_distance(of.a.vertices, of.pose_a, of.b.vertices, of.pose_b);
        };
        const auto still = exact(given);
        ASSERT_TRUE(still) << given.id << ": " << still.error;
        for (const int turn : {1, 10, 23}) {
            const scene::Case there = turned(given, turn);
            EXPECT_EQ(exact(there)->distance, still->distance) << given.id;
            EXPECT_EQ(exact(moved_exactly(there).value_or(there))->distance, still->distance) << given.id;
        }
    }
}

TEST_P(Corpus, IsAnsweredRightInAWorldTurnedAndMoved) {
    int moved = 0;
    for (std::size_t i = 0; i < corpus().size(); ++i) {
        const scene::Case& given = corpus()[i];
        expect_right(turned(given, 1 + static_cast<int>(i) % (quarter_turns - 1)));
        const auto elsewhere =
            moved_exactly(turned(given, 1 + static_cast<int>(i + 7) % (quarter_turns - 1)));
        moved += elsewhere.has_value();
        if (elsewhere) expect_right(*elsewhere);
    }
    print(" turned and moved");
    EXPECT_THAT(wrong_, testing::IsEmpty());
    EXPECT_EQ(moved, static_cast<int>(corpus().size()));
    EXPECT_EQ(worst_.refused, out_of_range(4, 4));
    EXPECT_GT(worst_.apart, holds_boxes_alone() ? 40 : 130);
    EXPECT_GT(worst_.contact, 130);
}

std::optional<bench::NamedAnswer> answer_to(const scene::Case& of, bench::Runner& runner) {
    const auto a = scene::body_from_case(of.a);
    const auto b = scene::body_from_case(of.b);
    if (!a || !b || !runner.load(std::vector<Polyhedron>{*a, *b}).empty()) return std::nullopt;
    return runner.answer(scene::Query{0, 1, 0, of.pose_a, of.pose_b});
}

/// The answer to the case scaled by 2^power must be the scaled answer to the case, to the bit.
void expect_scaled(const scene::Case& given, const std::optional<bench::NamedAnswer>& plain, int power,
                   bench::Runner& runner, int& compared) {
    SCOPED_TRACE(given.id + " times 2^" + std::to_string(power));
    const auto scaled = answer_to(scaled_by_power(given, power), runner);
    ASSERT_EQ(plain.has_value(), scaled.has_value());
    if (!plain) return;
    const double factor = std::ldexp(1.0, power);
    EXPECT_EQ(plain->distance.status, scaled->distance.status);
    EXPECT_EQ(plain->distance.distance * factor, scaled->distance.distance);
    EXPECT_EQ(Vec3d(plain->distance.point_a * factor), scaled->distance.point_a);
    EXPECT_EQ(Vec3d(plain->distance.point_b * factor), scaled->distance.point_b);
    EXPECT_EQ(plain->distance.steps, scaled->distance.steps);
    EXPECT_EQ(plain->feature_a.vertices, scaled->feature_a.vertices);
    EXPECT_EQ(plain->depth * factor, scaled->depth);
    ++compared;
}

TEST_P(Corpus, IsAnsweredAlikeAtEveryScale) {
    const bool stored_single = GetParam().type.single_storage;
    int compared = 0;
    for (const scene::Case& given : corpus()) {
        const auto plain = answer_to(given, *runner_);
        for (const int power : {-20, -13, 20, stored_single ? 13 : -60, stored_single ? 7 : 60})
            expect_scaled(given, plain, power, *runner_, compared);
    }
    EXPECT_GT(compared, holds_boxes_alone() ? 400 : 800);
}

std::vector<Subject> subjects() {
    std::vector<Subject> all;
    for (const bench::TableType& type : bench::table_types()) {
        for (const std::string& algorithm : type.algorithms) all.push_back({type, algorithm});
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(Every, Corpus, testing::ValuesIn(subjects()),
                         [](const auto& of) { return of.param.type.name + "_" + of.param.algorithm; });

}  // namespace
}  // namespace edgewise
