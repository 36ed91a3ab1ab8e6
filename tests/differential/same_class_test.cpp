// SPDX-License-Identifier: MIT
//
// Table types that exact arithmetic does not check (CMakeLists.txt): each gives, to the bit, the answers of a
// table type that it does check. The pairs are in every relation and at every gap of PairMaker, cold and
// warm, of solids and of flat bodies. The query loops are the program's own, or of a layout that the program
// leaves out (EDGEWISE_EVERY_LAYOUT) those for tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/registry.hpp"
#include "random_workloads.hpp"
#include "representatives.hpp"

namespace edgewise {
namespace {

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
    static const std::vector<scene::Workload> workloads = random_workloads(1000);
    for (const scene::Workload& asked : workloads) {
        const auto runner = type.make_runner(algorithm);
        EXPECT_EQ(runner->load(asked), "") << type.name;
        for (const Distance& answer : runner->answer()) add(print, answer);
    }
    return print.hex();
}

TEST(SameClass, EveryTableTypeAnswersAsOneThatIsJudged) {
    std::map<std::string, std::string> classes,
        others;  // algorithm and answers -> cell; cell -> algorithm and answers
    const std::vector<Polyhedron> all = bodies_of_random_pairs();
    for (const bench::TableType& type : bench::table_types()) {
        const bool holds_all = std::all_of(all.begin(), all.end(), [&](const Polyhedron& body) {
            return static_cast<bool>(type.stored_body(body));
        });
        if (!holds_all) {  // no other table type answers the same bodies
            EXPECT_TRUE(representatives.contains(type.name)) << type.name;
            continue;
        }
        for (const std::string& algorithm : type.algorithms) {
            const std::string given = algorithm + " " + answers(type, algorithm);
            if (representatives.contains(type.name)) {
                classes.emplace(given, type.name);
            } else {
                others.emplace(type.name + " " + algorithm, given);
            }
        }
    }
    ASSERT_FALSE(classes.empty());
    for (const auto& [cell, given] : others) {
        const auto found = classes.find(given);
        EXPECT_NE(found, classes.end()) << cell << " answers as no table type that exact arithmetic checks";
        if (found != classes.end()) std::printf("%s answers as %s\n", cell.c_str(), found->second.c_str());
    }
    std::printf("%zu classes of equal answers checked, %zu table types x algorithms compared with them\n",
                classes.size(), others.size());
}

}  // namespace
}  // namespace edgewise
