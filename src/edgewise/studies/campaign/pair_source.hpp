// SPDX-License-Identifier: MIT
//
// Source of a campaign's pairs: each of 10^9 pairs can be made again from the seed and its number alone.
//
// Pairs come in blocks of one pair of bodies, since a body is a hull and a table per layout, and a pose is a
// few dozen multiplications. Families take turns, a block each. Two kinds:
//   random   a named shape against itself, or stretched: free poses, poses at a wanted gap or depth, nearly
//   and
//            exactly parallel ones, lattices
//   hard     a pair of a hard family (scene/hard) as it is made, then other poses near it: moved along the
//            shortest connection to another gap, sideways, tilted, turned by quarter turns, carried off
// Which pose is drawn from a generator seeded by seed, family, block and number; + - * / sqrt alone.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/geometry/result.hpp"
#include "edgewise/scene/hard/families.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::studies::campaign {

inline constexpr const char* random_family = "random";  ///< of named bodies; others have their own

inline constexpr std::uint64_t pairs_per_block = 4096;

/// Position of a pair in the campaign.
struct PairPlace {
    std::uint64_t block = 0, number = 0;  ///< the number in its block

    [[nodiscard]] static PairPlace of(std::uint64_t pair) {
        return {pair / pairs_per_block, pair % pairs_per_block};
    }
    [[nodiscard]] std::uint64_t pair() const { return block * pairs_per_block + number; }
};

/// Two bodies and their poses, pair by pair; or why there are none.
struct Block {
    std::string family;
    scene::CaseBody case_a, case_b;
    Polyhedron a, b;
    std::vector<std::pair<Pose, Pose>> poses;
    std::string refusal;  ///< of bodies that no table can hold, as some hard family makes them
};

class PairSource {
  public:
    /// Families by name: "random", one for each shape, and those of scene::hard_families(). `shapes`: as
    /// scene::make_shape takes them. Throws std::invalid_argument that lists the known names.
    PairSource(std::uint64_t seed, const std::vector<std::string>& families,
               const std::vector<std::string>& shapes, const scene::MeshReading& reading = {});

    /// Names in the order in which they take turns: "random cube8", "grazing".
    [[nodiscard]] const std::vector<std::string>& families() const { return names_; }

    /// What was done to bodies of mesh files; empty: nothing.
    [[nodiscard]] const std::string& warning() const { return warning_; }
    /// Names the bodies' contents: equal for equal bodies.
    [[nodiscard]] std::string print() const;

    /// Returns the first `count` pairs of a block.
    [[nodiscard]] Block block(std::uint64_t number, std::uint64_t count = pairs_per_block) const;

  private:
    void add(const std::string& family, const std::vector<std::string>& shapes,
             const scene::MeshReading& reading);

    std::uint64_t seed_;
    std::string warning_;
    std::vector<std::string> names_;
    std::map<std::string, Polyhedron> shapes_;              ///< of random families, by the family's name
    std::map<std::string, const scene::HardFamily*> hard_;  ///< by the family's name
};

// Turns a block's pairs into queries of one pair, in time order, each from cold.

[[nodiscard]] inline scene::Workload workload_of(const Block& block) {
    scene::Workload workload;
    workload.bodies = {block.a, block.b};
    workload.instances = {0, 1};
    workload.pair_count = 1;
    workload.queries.reserve(block.poses.size());
    for (const auto& [pose_a, pose_b] : block.poses)
        workload.queries.push_back({0, 1, 0, pose_a, pose_b, 0, 1});
    return workload;
}

}  // namespace edgewise::studies::campaign
