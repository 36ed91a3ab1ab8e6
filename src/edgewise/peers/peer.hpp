// SPDX-License-Identifier: MIT
//
// Another library to compare with Edgewise: what its adapter offers, and how the program finds it.
//
// An adapter is a module of its own, opened while the program runs: libraries that come in two precisions
// have the same symbols twice, each needs its own flags, and a program without them still runs. A module
// takes nothing from the program; this header, and what it includes, is all that the two share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise::peers {

/// A query as a peer takes it: the shapes, their poses, and the pair's cache.
struct PeerQuery {
    std::uint32_t shape_a, shape_b;  ///< in the order of the bodies that shapes were made of
    std::uint32_t pair;              ///< queries of one pair follow each other in time
    Pose pose_a, pose_b;
    double radius_a = 0, radius_b = 0;  ///< around the shapes
};

/// In world coordinates, as the library gives them.
struct PeerAnswer {
    bool answered = true;  ///< else the library reports a failure
    bool separated = false;
    double distance = 0;  ///< 0 when not separated; meaningless where the verdict alone is asked or given
    Vec3d point_a = Vec3d::Zero(), point_b = Vec3d::Zero();  ///< witnesses, when separated
};

/// One library at work: shapes, poses and caches in its own types. All that is not the query itself is done
/// before run().
class PeerBench {
  public:
    PeerBench() = default;
    PeerBench(const PeerBench&) = delete;
    PeerBench& operator=(const PeerBench&) = delete;
    virtual ~PeerBench() = default;

    /// Makes one shape for each body, and replaces the earlier shapes.
    virtual void make_shapes(std::span<const Polyhedron* const> bodies) = 0;
    /// Poses in the library's type. `pairs`: number of caches that are kept from query to query; 0: every
    /// query starts cold. `verdict_alone`: only whether bodies are separated is asked, in the fastest way.
    virtual void prepare(std::span<const PeerQuery> queries, std::size_t pairs, bool verdict_alone) = 0;
    /// All pairs cold again.
    virtual void set_back() = 0;
    /// Queries first .. last - 1; the sum of their distances. Answers are written from answers[first] on
    /// unless it is null.
    virtual double run(std::size_t first, std::size_t last, PeerAnswer* answers) = 0;

    /// Bytes of a shape's object, without what it allocates, and of a pair's cache.
    [[nodiscard]] virtual std::size_t object_bytes() const = 0;
    [[nodiscard]] virtual std::size_t cache_bytes() const = 0;
};

/// A module's description of its library.
struct PeerInfo {
    const char* name;       ///< the adapter's stem: "bullet_epa2"
    const char* precision;  ///< what it stores and computes in: "f64", "f32", or "mixed", stored in single
    const char* library;    ///< with its version: "Bullet 3.24"
    const char* summary;    ///< which of its queries, in one line
    const char* cache;      ///< what a pair keeps, in one line
    const char* flags;      ///< what the adapter and the library's own headers were compiled with
    bool verdict_only;      ///< it gives no distance
    PeerBench* (*make)();   ///< the caller deletes it
};

/// The name that every module exports: `extern "C" const PeerInfo* edgewise_peer()`.
inline constexpr const char* peer_symbol = "edgewise_peer";
using PeerFunction = const PeerInfo* (*)();

}  // namespace edgewise::peers
