// SPDX-License-Identifier: MIT
//
// A user's own tree, and the lock of its layout. To time it, use PlainReads.
#include <algorithm>
#include <array>
#include <edgewise/measure/cache/machine_choice.hpp>
#include <edgewise/measure/lock/lock_program.hpp>
#include <edgewise/measure/touch/touch_trace.hpp>
#include <random>

namespace measure = edgewise::measure;
using Point = std::array<int, 2>;
enum Field { point, children };
struct Node {
    Point point;
#ifdef ADDED_MEMBER  // as a later change may add one
    int colour = 0;
#endif
    std::array<int, 2> children = {-1, -1};
};

int build(std::span<Point> points, int axis, std::vector<Node>& tree) {
    if (points.empty()) return -1;
    std::ranges::sort(points, {}, [axis](const Point& p) { return std::pair(p[axis], p[1 - axis]); });
    const std::size_t middle = points.size() / 2, at = tree.size();
    tree.push_back({.point = points[middle]});
    const int below = build(points.first(middle), 1 - axis, tree);
    const int above = build(points.subspan(middle + 1), 1 - axis, tree);
    tree[at].children = {below, above};
    return static_cast<int>(at);
}

int count(const auto& reads, const std::vector<Node>& tree, int at, int axis, const Point& low) {
    if (at < 0) return 0;  // else the points in the square of 100 above `low`
    const Point& p = reads.load(tree[at].point, Field::point);
    const auto& [below, above] = reads.load(tree[at].children, Field::children);
    int found = p[0] >= low[0] && p[1] >= low[1] && p[0] < low[0] + 100 && p[1] < low[1] + 100;
    if (p[axis] >= low[axis]) found += count(reads, tree, below, 1 - axis, low);
    if (p[axis] < low[axis] + 100) found += count(reads, tree, above, 1 - axis, low);
    return found;
}

int main(int argc, char** argv) {
    std::mt19937 random(1);
    std::vector<Point> points(4000), questions(500);
    for (auto* some : {&points, &questions})
        for (Point& p : *some) p = {static_cast<int>(random() % 1000), static_cast<int>(random() % 1000)};
    std::vector<Node> tree;
    build(points, 0, tree);
    measure::Structure structure;
    structure.add_array("nodes", tree, {{"point", sizeof(Point)}, {"children", sizeof(Node::children)}});
    measure::TouchTrace trace(structure, {"point", "children"});
    for (const Point& question : questions) {
        trace.start_query();
        count(measure::TouchReads(trace), tree, 0, 0, question);
    }
    const auto machines = measure::described_machines({"pentium3_coppermine", "zen5"});
    return measure::lock_program(argc, argv, measure_layout(trace, machines), {{"points", "4000"}});
}
