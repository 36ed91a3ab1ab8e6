// SPDX-License-Identifier: MIT
//
// Points, segments, triangles and polygons against each other and against a solid: random pairs in every
// relation and at every gap of PairMaker, each answer compared with the exact one, from a cold and from a
// warm start. V-Clip only needs the two sides of a polygon for flat bodies: its fallback stays rare in
// generic poses.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "judged.hpp"
#include "query_poses.hpp"
#include "stored_bodies.hpp"
#include "tables_under_test.hpp"

namespace edgewise {
namespace {

constexpr int pairs_a_setting = 300;

template <class Table>
std::vector<NamedBody> bodies() {
    std::vector<NamedBody> all = flat_bodies();
    all.push_back({"cube", shape("cube8")});
    std::erase_if(all, [](const NamedBody& named) { return !holds<Table>(named.body); });
    for (NamedBody& named : all) named.body = as_stored<Table>(named.body);
    return all;
}

/// With planes stored in single, V-Clip finds the closest feature only to about 1e-7, although it then
/// computes the distance more exactly.
template <class Algorithm, class Table>
constexpr bool planes_are_rounded =
    std::is_same_v<Algorithm, VClip>&& stored_eps<Table> > 2 * compute_eps<Table>;

template <class Table>
struct FlatTally {
    std::array<double, classes> error{};
    double witness = 0;
    int wrong = 0, apart = 0, contact = 0, generic = 0, generic_fallbacks = 0;

    void add(const Distance& answer, const CheckedPair& checked, const Judged& judged) {
        double& worst = error[static_cast<std::size_t>(classify<Table>(checked))];
        worst = std::max(worst, judged.distance_error);
        witness = std::max(witness, judged.witness_error);
        wrong += judged.verdict_wrong;
        ++(checked.separated() ? apart : contact);
        const bool clear = checked.pair.relation == Relation::generic && checked.separated() &&
                           checked.exact.distance > 1e-3 * checked.band.scale;
        generic += clear;
        generic_fallbacks += clear ? answer.fallbacks : 0;
    }
};

template <class Algorithm, class Table>
void compare(const NamedBody& of_a, const NamedBody& of_b, FlatTally<Table>& tally) {
    const Table a(of_a.body, Algorithm::parts), b(of_b.body, Algorithm::parts);
    using Pair = typename Algorithm::template Pair<Table, Table>;
    PairMaker maker(of_a.body, of_b.body, 3);
    Pair warm(a, b);
    for (int i = 0; i < pairs_a_setting; ++i) {
        const CheckedPair checked = check_pair(of_a.body, of_b.body, maker.next(), compute_eps<Table>);
        Pair cold(a, b);
        for (Pair* pair : {&cold, &warm}) {
            const Distance answer = Algorithm::query(a, b, checked.a_from_b, *pair);
            const Judged judged = judge_answer(answer, checked, of_a.body, of_b.body);
            EXPECT_FALSE(judged.verdict_wrong) << of_a.name << " " << of_b.name << " " << i;
            tally.add(answer, checked, judged);
        }
    }
}

template <class Type>
class FlatPairs : public ::testing::Test {};
TYPED_TEST_SUITE(FlatPairs, TableTypes);

TYPED_TEST(FlatPairs, AnswersAreRightFromAnyStart) {
    using Table = typename TypeParam::Table;
    if (bodies<Table>().size() == 1) GTEST_SKIP() << "this layout holds no flat body";
    for_each_algorithm<Table>([&]<class Algorithm>(Algorithm) {
        constexpr bool rounded = planes_are_rounded<Algorithm, Table>;
        FlatTally<Table> tally;
        for (const NamedBody& a : bodies<Table>()) {
            for (const NamedBody& b : bodies<Table>()) compare<Algorithm>(a, b, tally);
        }
        std::printf(
            "%s %s: error %.2g, close and parallel %.2g, witness %.2g, %d apart, %d in contact, fallbacks %d "
            "of %d\n",
            TypeParam::name, std::string(Algorithm::name).c_str(), tally.error[0], tally.error[1],
            tally.witness, tally.apart, tally.contact, tally.generic_fallbacks, tally.generic);
        EXPECT_LE(tally.error[0], rounded ? 1e-9 : error_allowed<Table>(Class::plain));
        EXPECT_LE(tally.error[1], rounded ? 1e-3 : error_allowed<Table>(Class::parallel));
        EXPECT_LE(tally.witness, verified_error<Table>);
        EXPECT_GT(tally.apart, 1000);
        EXPECT_GT(tally.contact, 200);
        EXPECT_GT(tally.generic, 500);
        EXPECT_LE(tally.generic_fallbacks, tally.generic / 100);
    });
}

}  // namespace
}  // namespace edgewise
