// SPDX-License-Identifier: MIT
//
// A library is wrong where it gave no answer, and not where it was never asked.
#include "edgewise/studies/judge/pair_judge.hpp"

#include <gtest/gtest.h>

#include "edgewise/bench/peers/peer_modules.hpp"
#include "edgewise/peers/peer_bench_for.hpp"

namespace edgewise::studies {
namespace {

/// Answers nothing, whatever it is asked.
struct Silent {
    struct Shape {
        explicit Shape(const Polyhedron&) {}
    };
    struct Placed {
        explicit Placed(const Pose&) {}
    };
    struct Cache {};

    static peers::PeerAnswer query(const Shape&, const Placed&, const Shape&, const Placed&, Cache&, bool) {
        return {.answered = false};
    }
};

constexpr peers::PeerInfo silent = {"silent",  "f64", "none", "silence",
                                    "nothing", "",    false,  peers::make_bench<Silent>};

JudgedResponse asked_at(double distance) {
    bench::TableType type;
    type.name = "silent_f64";
    type.algorithms = {"silent"};
    type.is_peer = true;
    type.make_runner = [](std::string_view) { return std::make_unique<bench::PeerRunner>(silent); };
    const scene::CaseBody body{"body", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}};
    scene::Case pair{"pair", body, body, {}, {}};
    pair.pose_b.translation.x() = distance;
    return ask({&type, "silent"}, pair, exact_truth_of(pair).or_throw());
}

TEST(PairJudge, ALibraryThatIsNotAskedIsNotWrong) {
    const JudgedResponse near = asked_at(3), far = asked_at(1e100);
    EXPECT_EQ(near.is, AnswerIs::no_answer);
    EXPECT_TRUE(near.wrong());
    EXPECT_EQ(far.is, AnswerIs::refused);
    EXPECT_FALSE(far.wrong());
    EXPECT_EQ(far.why, "too large, too small or too far apart for this precision");
}

}  // namespace
}  // namespace edgewise::studies
