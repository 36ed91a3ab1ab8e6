// SPDX-License-Identifier: MIT
//
// A layout that derives its planes takes another walk to the same features. Compares V-Clip on every table
// type with V-Clip on aos in the same storage, on the corpus and on generic pairs of spheres and boxes.
// Features are compared if the exact closest features are unique; status and distance always.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "corpus.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise {
namespace {

struct Asked {
    scene::Query query;
    std::map<std::string, bool> unique =
        {};  ///< closest features, of the bodies as this table type stores them
};

/// Two bodies and what is asked of them.
struct Questions {
    std::vector<Polyhedron> bodies;
    std::vector<Asked> asked;
};

/// Number of vertices that are lowest along a direction, to a billionth of the size.
std::size_t lowest(const Polyhedron& body, const Pose& pose, const Vec3d& along) {
    std::vector<double> heights;
    for (const Vec3d& v : body.vertices) heights.push_back(dot(pose.apply(v), along));
    const double least = *std::min_element(heights.begin(), heights.end());
    const double size = extent(body.vertices) * norm(along);
    return static_cast<std::size_t>(
        std::count_if(heights.begin(), heights.end(), [&](double h) { return h - least <= 1e-9 * size; }));
}

/// Returns true if the bodies are apart and each nearest point lies inside one feature, without parallel
/// features.
bool has_unique_features(std::span<const Polyhedron> stored, const scene::Query& query) {
    const auto exact =
        truth::exact_distance(stored[0].vertices, query.pose_a, stored[1].vertices, query.pose_b);
    if (!exact || exact->verdict != truth::ExactVerdict::separated) return false;
    const Vec3d along = exact->separation;
    const std::size_t on_a = lowest(stored[0], query.pose_a, along);
    const std::size_t on_b = lowest(stored[1], query.pose_b, Vec3d(-along));
    if (std::min(on_a, on_b) > 1 && on_a + on_b > 4) return false;
    return exact->simplex.size == static_cast<int>(std::min<std::size_t>(3, on_a + on_b - 1));
}

std::vector<Index> sorted(std::vector<Index> names) {
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<Questions> questions() {
    std::vector<Questions> all;
    for (const scene::Case& given : corpus()) {
        const auto a = scene::body_from_case(given.a);
        const auto b = scene::body_from_case(given.b);
        all.push_back({{*a, *b}, {{{0, 1, 0, given.pose_a, given.pose_b}}}});
    }
    scene::Rng rng(3);
    for (const char* name : {"cube8", "sphere38", "sphere386"}) {
        const Polyhedron body = *scene::make_shape(name);
        Questions& of_body = all.emplace_back(Questions{{body, body}, {}});
        for (int i = 0; i < 400; ++i) {
            scene::Query query{0, 1, 0, {rng.rotation(), Vec3d::Zero()}, {rng.rotation(), Vec3d::Zero()}};
            query.pose_b.translation = extent(body.vertices) * rng.uniform(0.3, 1.5) * rng.on_sphere();
            of_body.asked.push_back({query});
        }
    }
    return all;
}

struct Tally {
    int compared = 0, unique = 0, other_features = 0, other_status = 0;
    double difference = 0;  ///< of distances, in units of the scale
};

void compare(const std::string& plain_name, const bench::Runner& plain, const bench::Runner& other,
             std::span<const Polyhedron> stored, Asked& asked, double eps, Tally& tally) {
    const bench::NamedAnswer expected = plain.answer(asked.query), found = other.answer(asked.query);
    const truth::AccuracyBand band = truth::accuracy_band(stored[0].vertices, asked.query.pose_a,
                                                          stored[1].vertices, asked.query.pose_b, eps);
    const double off = std::abs(expected.distance.distance - found.distance.distance);
    ++tally.compared;
    if (off > 0) tally.difference = std::max(tally.difference, (off - band.band) / band.scale);
    tally.other_status += expected.distance.status != found.distance.status && off > band.band;
    const auto [unique, is_new] = asked.unique.try_emplace(plain_name);
    if (is_new) unique->second = has_unique_features(stored, asked.query);
    if (!unique->second) return;
    ++tally.unique;
    tally.other_features += sorted(expected.feature_a.vertices) != sorted(found.feature_a.vertices) ||
                            sorted(expected.feature_b.vertices) != sorted(found.feature_b.vertices);
}

TEST(LayoutsAgree, OnFeaturesStatusAndDistance) {
    auto all = questions();
    int most_unique = 0;
    for (const bench::TableType& type : bench::table_types()) {
        const bool single = type.eps > Tolerance<double>::eps;
        const auto is_plain = [&](const bench::TableType& t) {
            return t.layout == "aos" && t.storage == type.storage && t.eps == type.eps;
        };
        const auto plain = std::find_if(bench::table_types().begin(), bench::table_types().end(), is_plain);
        if (plain == bench::table_types().end() || plain->name == type.name || !type.serves("vclip"))
            continue;
        const auto of_plain = plain->make_runner("vclip"), of_type = type.make_runner("vclip");
        Tally tally;
        for (Questions& questions : all) {
            if (!of_plain->load(questions.bodies).empty() || !of_type->load(questions.bodies).empty())
                continue;
            const auto stored = of_plain->stored_bodies();
            for (Asked& asked : questions.asked)
                compare(plain->name, *of_plain, *of_type, stored, asked, type.eps, tally);
        }
        std::printf(
            "%s: %d of %d pairs have unique features; %d other features, %d other status, distance %.2g\n",
            type.name.c_str(), tally.unique, tally.compared, tally.other_features, tally.other_status,
            tally.difference);
        EXPECT_GT(tally.unique, 500) << type.name;
        // In single, rounding may decide between features that are unique by a small margin. A layout that
        // only holds small bodies has the same such pairs among fewer, so the bound is a hundredth of the
        // most pairs.
        most_unique = std::max(most_unique, tally.unique);
        EXPECT_LE(tally.other_features, single || plain->rounded_planes ? most_unique / 100 : 0) << type.name;
        EXPECT_EQ(tally.other_status, 0) << type.name;
        EXPECT_LE(tally.difference,
                  truth::allowed_errors(type.eps, type.rounded_planes || plain->rounded_planes).distance)
            << type.name;
    }
}

}  // namespace
}  // namespace edgewise
