// SPDX-License-Identifier: MIT
//
// Verification: right answers pass, and every kind of wrong one is seen and said.
#include "edgewise/sweep/prepared_cell.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "edgewise/algorithms/rounded.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::sweep {
namespace {

using ::testing::HasSubstr;

constexpr double eps = Tolerance<double>::eps;

Plan small_plan() {
    Plan plan;
    plan.seed = 3;
    plan.queries = 120;
    plan.checked = 60;
    return plan;
}

class Verify : public ::testing::Test {
  protected:
    Verify()
        : shared_(small_plan(), SceneChoice{"cold", {{"overlapping", 0.3}}},
                  scene::NamedShape{"cube8", "built-in", *scene::make_shape("cube8"), ""}) {
        for (const scene::Query& query : shared_.workload().queries) {
            const auto exact = truth::exact_distance(body(query.body_a).vertices, query.pose_a,
                                                     body(query.body_b).vertices, query.pose_b);
            EXPECT_TRUE(exact) << exact.error;
            Distance answer;
            answer.status =
                exact->verdict == truth::ExactVerdict::separated ? Status::separated : Status::overlapping;
            answer.distance = exact->distance;
            answer.point_a = exact->separation;  // as far from the other point, the origin, as the bodies are
            answer.steps = 2;
            answers_.push_back(answer);
        }
    }

    [[nodiscard]] const Polyhedron& body(std::uint32_t i) const { return shared_.workload().bodies[i]; }

    /// The first checked query with this verdict.
    [[nodiscard]] std::size_t first(Status status) const {
        for (const std::size_t i : shared_.checked()) {
            if (answers_[i].status == status) return i;
        }
        ADD_FAILURE() << "no " << to_string(status) << " pair";
        return 0;
    }

    [[nodiscard]] std::string wrong(double epsilon = eps, const QueryOptions& options = {}) {
        return what_is_wrong(
            shared_, check_answers(shared_, shared_.workload().bodies, answers_, epsilon, {.query = options}),
            epsilon);
    }

    SharedQueries shared_;
    std::vector<Distance> answers_;
};

TEST_F(Verify, RightAnswersPass) {
    EXPECT_EQ(wrong(), "");
    const auto checked = check_answers(shared_, shared_.workload().bodies, answers_, eps);
    ASSERT_EQ(checked.size(), 60U);
    std::size_t separated = 0;
    for (const truth::CheckedAnswer& answer : checked)
        separated += answer.exact == truth::ExactVerdict::separated;
    EXPECT_GT(separated, 30U);
    EXPECT_LT(separated, 55U);
}

TEST_F(Verify, WrongDistancesFailBeyondTheBoundOfThePrecision) {
    const std::size_t i = first(Status::separated);
    const double scale = 4;  // cubes of extent 1.95, some 2 to 4 apart
    answers_[i].distance += 0.1 * verified_error_double * scale;
    EXPECT_EQ(wrong(), "");
    answers_[i].distance += 10 * verified_error_double * scale;
    EXPECT_THAT(wrong(), HasSubstr("1 of 60 checked answers are wrong"));
    EXPECT_THAT(wrong(), HasSubstr("query " + std::to_string(i) + " (wrong distance)"));
    EXPECT_EQ(wrong(Tolerance<float>::eps), "");
    answers_[i].distance += 10 * verified_error_single * scale;
    EXPECT_NE(wrong(Tolerance<float>::eps), "");
}

TEST_F(Verify, WrongVerdictsFail) {
    answers_[first(Status::separated)].status = Status::overlapping;
    EXPECT_THAT(wrong(), HasSubstr("wrong verdict"));
}

/// The band excuses verdicts, not errors: an error beyond the bound is wrong however little it is beyond.
TEST_F(Verify, ErrorsCountFromZero) {
    const std::size_t i = first(Status::separated);
    const scene::Query& query = shared_.workload().queries[i];
    const truth::AccuracyBand band = truth::accuracy_band(body(query.body_a).vertices, query.pose_a,
                                                          body(query.body_b).vertices, query.pose_b, eps);
    const Distance right = answers_[i];
    for (const double part : {0.99, 1.001}) {
        const double longer = 1 + part * verified_error_double * band.scale / right.distance;
        answers_[i].distance = right.distance * longer;
        answers_[i].point_a = right.point_a * longer;
        ASSERT_LT(0.001 * verified_error_double * band.scale, band.band);
        EXPECT_EQ(wrong() != "", part > 1) << part;
    }
}

TEST_F(Verify, WitnessesThatDoNotMatchTheDistanceFail) {
    Distance& answer = answers_[first(Status::separated)];
    const Vec3d right = answer.point_a;
    answer.point_a *= 1.001;
    EXPECT_THAT(wrong(), HasSubstr("witness error"));
    answer.point_a = right * std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(wrong(), "");
}

TEST_F(Verify, AContactToleranceMovesTheVerdict) {
    const std::size_t i = first(Status::separated);
    const double distance = answers_[i].distance;
    answers_[i].status = Status::touching;
    EXPECT_THAT(wrong(), HasSubstr("wrong verdict"));
    // The others are still separated, and wrong with it if they are as near as that.
    for (std::size_t k = 0; k < answers_.size(); ++k) {
        if (answers_[k].distance <= distance * 1.001) answers_[k].status = Status::touching;
    }
    EXPECT_EQ(wrong(eps, {distance * 1.001, 0}), "");
    EXPECT_THAT(wrong(eps, {distance * 0.9, 0}), HasSubstr("wrong verdict"));
    answers_[i].status = Status::separated;
    EXPECT_THAT(wrong(eps, {distance * 1.001, 0}), HasSubstr("1 of 60 checked answers are wrong"));
}

/// Whatever the margin: below, at and above the distance of the pair.
TEST_F(Verify, NearnessIsJudgedByItsMargin) {
    const std::size_t i = first(Status::separated);
    const double distance = answers_[i].distance;
    const auto wrong_for = [&](double margin, const QueryOptions& options = {}) {
        return what_is_wrong(shared_,
                             check_answers(shared_, shared_.workload().bodies, answers_, eps,
                                           {.query = options, .needs = Needs::nearer},
                                           [&](const scene::Query&) { return margin; }),
                             eps);
    };
    for (const double part : {0.5, 1.0, 2.0}) {
        const double margin = part * distance;
        const std::vector<Distance> exact = answers_;
        for (Distance& answer : answers_)
            answer.status = answer.distance < margin ? Status::touching : Status::separated;
        EXPECT_EQ(wrong_for(margin), "") << part;
        Status& status = answers_[i].status;
        status = status == Status::touching ? Status::separated : Status::touching;
        if (part == 1) {
            EXPECT_EQ(wrong_for(margin), "") << "at the margin either is right";
        } else {
            EXPECT_THAT(wrong_for(margin), HasSubstr("1 of 60 checked answers are wrong")) << part;
        }
        status = Status::failed;
        EXPECT_THAT(wrong_for(margin), HasSubstr("wrong verdict")) << part;
        answers_ = exact;
    }
    for (Distance& answer : answers_)
        answer.status = answer.distance < distance * 1.001 ? Status::touching : Status::separated;
    answers_[i].status = Status::separated;
    EXPECT_THAT(wrong_for(distance * 1.001), HasSubstr("1 of 60"));
    EXPECT_EQ(wrong_for(distance * 1.001, {0, 0.002}), "") << "a gap tolerance makes distances longer";
}

/// Rounded bodies are as far apart as their cores, less the radii; nearer ones overlap.
TEST_F(Verify, RoundedBodiesAreJudgedByTheirCores) {
    const std::size_t i = first(Status::separated);
    const std::vector<Distance> cores = answers_;
    for (const double radii : {0.5 * cores[i].distance, 2 * cores[i].distance}) {
        for (Distance& answer : answers_) {
            if (answer.status == Status::separated) answer.normal = -answer.point_a / answer.distance;
            add_radii(0.25 * radii, 0.75 * radii, 0, answer);
        }
        const auto check_with = [&](const bench::RunnerOptions& options) {
            return check_answers(shared_, shared_.workload().bodies, answers_, eps, options,
                                 [&](const scene::Query&) { return radii; });
        };
        const auto wrong_with = [&](const bench::RunnerOptions& options) {
            return what_is_wrong(shared_, check_with(options), eps);
        };
        const bench::RunnerOptions distance{.radius = 1}, verdict{.query = {.cutoff = 0}, .radius = 1};
        EXPECT_EQ(wrong_with(distance), "");
        EXPECT_EQ(wrong_with(verdict), "");
        for (const truth::CheckedAnswer& checked : check_with(distance))
            EXPECT_EQ(checked.exact == truth::ExactVerdict::separated, checked.has_distance);
        Status& status = answers_[i].status;
        if (status == Status::separated) {
            answers_[i].distance += 1e-9;
            EXPECT_THAT(wrong_with(distance), HasSubstr("wrong distance"));
            EXPECT_EQ(wrong_with(verdict), "") << "it has no distance";
        }
        status = status == Status::separated ? Status::overlapping : Status::separated;
        EXPECT_THAT(wrong_with(distance), HasSubstr("1 of 60 checked answers are wrong"));
        EXPECT_THAT(wrong_with(verdict), HasSubstr("wrong verdict"));
        status = Status::failed;
        EXPECT_THAT(wrong_with(verdict), HasSubstr("wrong verdict"));
        answers_ = cores;
    }
}

/// A relative width of the answer itself: of the true distance it is a little more.
TEST_F(Verify, AGapToleranceIsAPartOfTheAnswer) {
    const QueryOptions options{.gap_tolerance = 0.01};
    const std::vector<Distance> exact = answers_;
    const auto wrong_when_longer = [&](double factor) {
        for (std::size_t i = 0; i < answers_.size(); ++i) {
            answers_[i].distance = exact[i].distance * factor;
            answers_[i].point_a = exact[i].point_a * factor;
        }
        return what_is_wrong(
            shared_, check_answers(shared_, shared_.workload().bodies, answers_, eps, {.query = options}),
            eps);
    };
    EXPECT_EQ(wrong_when_longer(1.01 + 5e-5), "");
    EXPECT_EQ(wrong_when_longer(1 / 0.99 - 1e-9), "");
    EXPECT_THAT(wrong_when_longer(1 / 0.99 + 1e-6), HasSubstr("wrong distance"));
}

TEST_F(Verify, UncheckedQueriesAreNotJudged) {
    ASSERT_EQ(shared_.checked()[1], 2U);
    answers_[1].distance += 1;
    EXPECT_EQ(wrong(), "");
}

TEST_F(Verify, CountsEverything) {
    answers_[0].fallbacks = 1;
    answers_[1].fallbacks = 1;
    answers_[1].cycles = 1;
    answers_[2].steps = 9;
    answers_[3].refinements = 1;
    answers_[4].escapes = 3;
    const bench::AnswerCounts counts = count_answers(answers_);
    EXPECT_EQ(counts.queries, 120U);
    EXPECT_EQ(counts.steps, 247U);
    EXPECT_EQ(counts.fallbacks, 2U);
    EXPECT_EQ(counts.cycles, 1U);
    EXPECT_EQ(counts.refinements, 1U);
    EXPECT_EQ(counts.escapes, 3U);
    EXPECT_EQ(counts.max_steps, 9);
}

}  // namespace
}  // namespace edgewise::sweep
