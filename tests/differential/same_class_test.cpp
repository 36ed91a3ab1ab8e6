// SPDX-License-Identifier: MIT
//
// Table types that exact arithmetic does not judge themselves (CMakeLists.txt): each gives, to the bit, the
// answers of one that it does judge, to random pairs in every relation and at every gap of PairMaker, cold
// and warm, of solids and of flat bodies. It is the program's own code that answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/shapes.hpp"
#include "random_pairs.hpp"
#include "representatives.hpp"

namespace edgewise {
namespace {

constexpr std::uint32_t pairs_per_setting = 1000;

Polyhedron hull(const std::vector<Vec3d>& points) {
    const auto body = hull_of_any(points);
    EXPECT_TRUE(body) << body.error;
    return *body;
}

std::vector<Polyhedron> bodies() {
    std::vector<Polyhedron> all = {hull({{0.25, -0.5, 0.125}}), hull({{-0.5, 0.25, 0}, {0.75, -0.25, 0.5}}),
                                   hull({{-0.5, 0, 0.25}, {0.75, 0, -0.25}, {0, 1, 0.5}}),
                                   hull({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}})};
    for (const char* name : {"tetra4", "cube8", "sphere38", "sphere386"}) {
        const auto body = scene::make_shape(name);
        EXPECT_TRUE(body) << body.error;
        all.push_back(*body);
    }
    return all;
}

/// Each body beside itself and beside the cube; one pair of bodies is one pair cache where starts are warm.
scene::Workload workload(bool warm) {
    scene::Workload all;
    all.bodies = bodies();
    all.warm = warm;
    constexpr std::uint32_t cube = 5;
    for (std::uint32_t a = 0; a < all.bodies.size(); ++a) {
        for (const std::uint32_t b : std::set<std::uint32_t>{a, cube}) {
            PairMaker maker(all.bodies[a], all.bodies[b], 100 + a);
            for (std::uint32_t i = 0; i < pairs_per_setting; ++i) {
                const RandomPair pair = maker.next();
                all.queries.push_back({a, b, all.pair_count, pair.pose_a, pair.pose_b});
            }
            ++all.pair_count;
        }
    }
    return all;
}

void add(bench::Fingerprint& print, const Distance& answer) {
    print.add(static_cast<std::uint64_t>(answer.status)).add(answer.distance);
    for (const Vec3d& point : {answer.point_a, answer.point_b})
        print.add(point.x()).add(point.y()).add(point.z());
    for (const int count :
         {answer.steps, answer.cycles, answer.fallbacks, answer.refinements, answer.escapes})
        print.add(static_cast<std::uint64_t>(count));
}

std::string answers(const bench::TableType& type, const std::string& algorithm) {
    bench::Fingerprint print;
    static const scene::Workload workloads[] = {workload(false), workload(true)};
    for (const scene::Workload& asked : workloads) {
        const auto runner = type.make_runner(algorithm);
        EXPECT_EQ(runner->load(asked), "") << type.name;
        for (const Distance& answer : runner->answer()) add(print, answer);
    }
    return print.hex();
}

TEST(SameClass, EveryTableTypeAnswersAsOneThatIsJudged) {
    std::set<std::string> judged;
    std::istringstream names(representatives);
    for (std::string name; names >> name;) judged.insert(name);
    std::map<std::string, std::string> classes, others;  // algorithm and answers -> who; who -> the same
    const std::vector<Polyhedron> all = bodies();
    for (const bench::TableType& type : bench::table_types()) {
        const bool holds_all = std::all_of(all.begin(), all.end(), [&](const Polyhedron& body) {
            return static_cast<bool>(type.stored_body(body));
        });
        if (!holds_all) {  // no other answers the same bodies
            EXPECT_TRUE(judged.count(type.name)) << type.name;
            continue;
        }
        for (const std::string& algorithm : type.algorithms) {
            const std::string given = algorithm + " " + answers(type, algorithm);
            if (judged.count(type.name)) {
                classes.emplace(given, type.name);
            } else {
                others.emplace(type.name + " " + algorithm, given);
            }
        }
    }
    ASSERT_FALSE(classes.empty());
    for (const auto& [who, given] : others) {
        const auto found = classes.find(given);
        EXPECT_NE(found, classes.end()) << who << " answers as none of those that exact arithmetic judges";
        if (found != classes.end()) std::printf("%s answers as %s\n", who.c_str(), found->second.c_str());
    }
    std::printf("%zu classes of equal answers judged, %zu table types x algorithms held to them\n",
                classes.size(), others.size());
}

}  // namespace
}  // namespace edgewise
