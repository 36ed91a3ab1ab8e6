// SPDX-License-Identifier: MIT
//
// The certificates of one answer: for the bodies that the tables hold, and the same widened to hold for the
// bodies as given.
#pragma once

#include <span>
#include <string>

#include "edgewise/bench/named_answer.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/truth/certificate.hpp"

namespace edgewise::bench {

struct Certificates {
    truth::Certificate stored, given;
};

/// `given` and `stored` are the bodies of the query (a runner's stored_bodies); `points` those that the given
/// bodies are the hulls of, where more is known than the hulls kept. Fails as certify does.
[[nodiscard]] Result<Certificates> certificates_of(const NamedAnswer& answer, const scene::Query& query,
                                                   std::span<const Polyhedron> given,
                                                   std::span<const Polyhedron> stored,
                                                   std::span<const Vec3d> points_a = {},
                                                   std::span<const Vec3d> points_b = {});

/// Why a distance cannot be that of bodies with this certificate: it is outside the interval by more than it
/// may be too short, or too long. Empty if it can be.
[[nodiscard]] std::string contradiction(double distance, const truth::Certificate& certificate,
                                        double too_short, double too_long);

}  // namespace edgewise::bench
