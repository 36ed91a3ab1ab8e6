// SPDX-License-Identifier: MIT
//
// One fuzzed pair through one algorithm in every precision, judged by exact arithmetic. A wrong answer is
// printed as a line for the corpus, and ends the run.
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "edgewise/bench/runner_for.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/layouts/aos.hpp"
#include "judged_case.hpp"
#include "pair_bytes.hpp"

namespace edgewise {

inline nlohmann::json json_of(const Vec3d& v) { return {v.x(), v.y(), v.z()}; }

inline nlohmann::json json_of(const scene::CaseBody& body) {
    nlohmann::json vertices = nlohmann::json::array();
    for (const Vec3d& v : body.vertices) vertices.push_back(json_of(v));
    return {{"vertices", vertices}};
}

inline nlohmann::json json_of(const Pose& pose) {
    const Mat3d& r = pose.rotation;
    return {{"R", {r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)}},
            {"t", json_of(pose.translation)}};
}

[[noreturn]] inline void report(const scene::Case& given, const JudgedCase& judged, std::string_view table) {
    const nlohmann::json line = {{"id", given.id},
                                 {"a", json_of(given.a)},
                                 {"b", json_of(given.b)},
                                 {"pose_a", json_of(given.pose_a)},
                                 {"pose_b", json_of(given.pose_b)}};
    fmt::print(stderr, "{}\n", line.dump());
    for (const std::string& complaint : judged.complaints) fmt::print(stderr, "{}: {}\n", table, complaint);
    std::abort();
}

template <class Algorithm, class P>
void fuzz_table(const scene::Case& given) {
    using Compute = typename P::Compute;
    // Planes stored in single keep V-Clip from the bounds of double even where double computes.
    const bool rounded_planes = std::is_same_v<typename P::Stored, float>;
    bench::RunnerFor<Algorithm, aos<P>, aos<P, Traced<measure::TraceSink>>> runner;
    const JudgedCase judged = judge_case(runner, {Tolerance<Compute>::eps, rounded_planes}, given);
    if (!judged.complaints.empty()) report(given, judged, P::name);
}

/// What libFuzzer calls; -1: not worth keeping.
template <class Algorithm>
int fuzz_pair(const std::uint8_t* data, std::size_t size) {
    const auto given = pair_from_bytes({data, size});
    if (!given) return -1;
    fuzz_table<Algorithm, f64>(*given);
    fuzz_table<Algorithm, f32>(*given);
    fuzz_table<Algorithm, mixed>(*given);
    return 0;
}

}  // namespace edgewise
