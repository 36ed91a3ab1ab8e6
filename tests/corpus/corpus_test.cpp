// SPDX-License-Identifier: MIT
//
// Every case of the corpus through every table type and algorithm, as given, swapped, and with its vertices
// listed backwards. The judge is the exact oracle on the bodies that the tables hold: verdict outside the
// band, distance, witness points, depth, and the certificates of the stored and of the given bodies. And
// every case at other scales, where the answer must be the same to the bit.
#include <gmock/gmock.h>

#include <cstdio>
#include <set>

#include "corpus.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/sweep/certificates.hpp"
#include "edgewise/sweep/registry.hpp"
#include "edgewise/truth/accuracy_band.hpp"
#include "edgewise/truth/exact_depth.hpp"

namespace edgewise {
namespace {

struct Worst {
    double distance = 0, witness = 0, depth = 0;  ///< over scale, beyond what the rotations owe
    int apart = 0, contact = 0, in_band = 0;
};

struct Subject {
    const TableType& type;
    std::string algorithm;

    [[nodiscard]] bool single() const { return type.eps > Tolerance<double>::eps; }
    [[nodiscard]] double error_allowed() const {
        return single() ? verified_error_single : verified_error_double;
    }
    [[nodiscard]] double depth_allowed() const {
        return single() ? verified_error_single : verified_depth_error_double;
    }
};

void PrintTo(const Subject& subject, std::ostream* out) { *out << subject.type.name << subject.algorithm; }

class Corpus : public testing::TestWithParam<Subject> {
  protected:
    void SetUp() override { runner_ = GetParam().type.make_runner(GetParam().algorithm); }

    void expect_right(const Case& given) {
        SCOPED_TRACE(given.id);
        id_ = given.id;
        const auto a = body_from_case(given.a);
        const auto b = body_from_case(given.b);
        ASSERT_TRUE(a && b) << a.error << b.error;
        const std::vector<Polyhedron> bodies = {*a, *b};
        ASSERT_EQ(runner_->load(bodies), "");
        const Query query{0, 1, 0, given.pose_a, given.pose_b};
        const NamedAnswer answer = runner_->answer(query);
        judge_distance(answer, query);
        judge_certificates(answer, query, bodies);
    }

    Worst worst_;
    std::set<std::string> wrong_;  ///< cases with a wrong verdict or distance

    std::unique_ptr<Runner> runner_;

  private:
    [[nodiscard]] std::span<const Vec3d> vertices(std::size_t body) const {
        return runner_->stored_bodies()[body].vertices;
    }

    [[nodiscard]] Result<ExactDistance> exact(const Query& query) const {
        return exact_distance(vertices(0), query.pose_a, vertices(1), query.pose_b);
    }

    void judge_distance(const NamedAnswer& answer, const Query& query) {
        const auto truth = exact(query);
        ASSERT_TRUE(truth) << truth.error;
        const AccuracyBand band =
            accuracy_band(vertices(0), query.pose_a, vertices(1), query.pose_b, GetParam().type.eps);
        const bool apart = answer.distance.status == Status::separated;
        std::optional<double> depth;
        if (truth->verdict != ExactVerdict::separated) {
            depth = exact_depth(vertices(0), query.pose_a, vertices(1), query.pose_b, truth->simplex)->depth;
        }
        const Judgement judged = judge({apart, answer.distance.distance}, *truth, band, depth);
        const double allowed = GetParam().error_allowed() * band.scale + band.band;
        if (judged.verdict_wrong || !(judged.error <= allowed)) wrong_.insert(id_);
        if (apart) judge_witness(answer, band);
        if (depth && !apart) judge_depth(answer, *depth, band);
        ++(apart ? worst_.apart : worst_.contact);
        worst_.in_band += judged.in_band;
        worst_.distance = std::max(worst_.distance, (judged.error - band.band) / band.scale);
    }

    void judge_witness(const NamedAnswer& answer, const AccuracyBand& band) {
        const double between = norm(Vec3d(answer.distance.point_a - answer.distance.point_b));
        const double error = std::abs(between - answer.distance.distance);
        EXPECT_LE(error, GetParam().error_allowed() * band.scale + band.band);
        worst_.witness = std::max(worst_.witness, (error - band.band) / band.scale);
    }

    void judge_depth(const NamedAnswer& answer, double depth, const AccuracyBand& band) {
        const double error = std::abs(answer.depth - depth);
        EXPECT_LE(error, GetParam().depth_allowed() * band.scale + band.band);
        if (depth > band.band) {
            EXPECT_EQ(answer.distance.status, Status::overlapping);
        }
        worst_.depth = std::max(worst_.depth, (error - band.band) / band.scale);
    }

    void judge_certificates(const NamedAnswer& answer, const Query& query,
                            const std::vector<Polyhedron>& bodies) {
        const auto certificates = certificates_of(answer, query, bodies, runner_->stored_bodies());
        ASSERT_TRUE(certificates) << certificates.error;
        const auto stored = exact(query);
        const auto given = exact_distance(bodies[0].vertices, query.pose_a, bodies[1].vertices, query.pose_b);
        EXPECT_LE(certificates->stored.lower, stored->distance);
        EXPECT_GE(certificates->stored.upper, stored->distance);
        EXPECT_LE(certificates->given.lower, given->distance);
        EXPECT_GE(certificates->given.upper, given->distance);
    }

    std::string id_;
};

TEST_P(Corpus, IsAnsweredRightHoweverItIsGiven) {
    ASSERT_GE(corpus().size(), 180U);
    for (const Case& given : corpus()) {
        expect_right(given);
        expect_right(swapped(given));
        expect_right(reversed(given));
    }
    std::printf("%s %s: error %.2g, witness %.2g, depth %.2g; %d apart, %d in contact, %d in the band\n",
                GetParam().type.name.c_str(), GetParam().algorithm.c_str(), worst_.distance, worst_.witness,
                worst_.depth, worst_.apart, worst_.contact, worst_.in_band);
    EXPECT_THAT(wrong_, testing::IsEmpty());
    EXPECT_GT(worst_.apart, 200);
    EXPECT_GT(worst_.contact, 200);
}

/// The answer to the case scaled by 2^power must be the answer to the case, scaled; to the bit.
void expect_scaled(const Case& given, int power, Runner& runner, int& compared) {
    SCOPED_TRACE(given.id + " times 2^" + std::to_string(power));
    const auto answer_to = [&](const Case& of) -> std::optional<NamedAnswer> {
        const auto a = body_from_case(of.a);
        const auto b = body_from_case(of.b);
        if (!a || !b || !runner.load(std::vector<Polyhedron>{*a, *b}).empty()) return std::nullopt;
        return runner.answer(Query{0, 1, 0, of.pose_a, of.pose_b});
    };
    const auto plain = answer_to(given), scaled = answer_to(scaled_by_power(given, power));
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
    for (const Case& given : corpus()) {
        for (const int power : {-20, -13, 20, stored_single ? 13 : -60, stored_single ? 7 : 60}) {
            expect_scaled(given, power, *runner_, compared);
        }
    }
    EXPECT_GT(compared, 800);
}

std::vector<Subject> subjects() {
    std::vector<Subject> all;
    for (const TableType& type : table_types()) {
        for (const std::string& algorithm : type.algorithms) all.push_back({type, algorithm});
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(Every, Corpus, testing::ValuesIn(subjects()),
                         [](const auto& of) { return of.param.type.name + "_" + of.param.algorithm; });

}  // namespace
}  // namespace edgewise
