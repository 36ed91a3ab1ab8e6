// SPDX-License-Identifier: MIT
#include "edgewise/truth/filter/float_proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "edgewise/geometry/double_double.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::truth {

namespace {

/// Vertices count as level within this slack, over the span of the pair. At most this many pairs of them,
/// those of two quadrilaterals, are tried before the next scan. Neither number decides anything.
constexpr double level_slack = 0x1p-24;
constexpr std::size_t most_level_pairs = 16;
constexpr int most_proof_steps = 64;  // a cap on wasted time only: exact arithmetic takes over from there

/// The weights of the simplex's nearest point, up to a factor; the simplex was found with these signs
/// positive.
std::array<double, 3> proof_weights(const MinimumSimplex<Vec3d>& s) {
    const auto& p = s.point;
    if (s.size == 1) return {1, 0, 0};
    if (s.size == 2) {
        const Vec3d along = p[1] - p[0];
        return {std::max(0.0, dot(p[1], along)), std::max(0.0, -dot(p[0], along)), 0};
    }
    const Vec3d first = p[1] - p[0], second = p[2] - p[0], normal = cross(first, second);
    return {std::max(0.0, dot(normal, cross(p[1], p[2]))), std::max(0.0, dot(normal, cross(p[2], p[0]))),
            std::max(0.0, dot(normal, cross(p[0], p[1])))};
}

double squared_gap(const MinimumSimplex<Vec3d>& simplex) {
    return simplex.height * simplex.height / squared_norm(simplex.direction);
}

// The two bounds of a distance again, where those in double are too far from each other: the few vertices
// that decide are computed as sums of two doubles. A world coordinate is three exact products and an exact
// difference of translations, summed in double-double: off by less than 2^-96 of the lengths in it. So is a
// height along a unit direction.

/// Error bound of double-double sums, relative to the lengths in them: 2^-96 with a margin of 64.
constexpr double wide_rounding = 0x1p-90;

/// R v
DoubleDoubleVec turned(const Pose& pose, const Vec3d& v) {
    DoubleDoubleVec result;
    for (int i = 0; i < 3; ++i) result[i] = accurate_dot(Vec3d(pose.rotation.row(i)), v);
    return result;
}

DoubleDoubleVec offset_of(const PosedPair& pair) {
    return exact_difference(pair.pose_b().translation, pair.pose_a().translation, 1);
}

/// The highest of the candidates along the direction.
DoubleDouble highest(std::span<const std::uint32_t> candidates, const ScannedBody& body, const Pose& pose,
                     const Vec3d& direction) {
    const DoubleDoubleVec along = cast<DoubleDouble>(direction);
    DoubleDouble best = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : candidates) {
        const DoubleDouble height = dot(turned(pose, body.vertex(i)), along);
        if (height > best) best = height;
    }
    return best;
}

/// A height of A - B along the direction that none of its points is below, after a scan along it: only
/// vertices that the scan cannot distinguish from the lowest are computed again.
double wide_least_height(PosedPair& pair, const Vec3d& direction, const ScannedLowest& scanned) {
    constexpr double u = proof_rounding;
    const auto of_a = pair.a().as_high_as(scanned.height_a - 2.5 * scanned.error_a);
    const auto of_b = pair.b().as_high_as(scanned.height_b - 2.5 * scanned.error_b);
    const DoubleDouble least_a = -highest(of_a, pair.a(), pair.pose_a(), -direction);
    const DoubleDouble most_b = highest(of_b, pair.b(), pair.pose_b(), direction);
    const double height = (least_a - most_b - dot(offset_of(pair), cast<DoubleDouble>(direction))).value();
    return height - u * std::abs(height) - wide_rounding * pair.span();
}

/// An upper bound of the length of the mean of the simplex's points with these weights, which are not
/// negative.
double wide_length(const PosedPair& pair, const MinimumSimplex<Vec3d>& simplex,
                   const std::array<double, 3>& weights) {
    constexpr double u = proof_rounding;
    const DoubleDoubleVec offset = offset_of(pair);
    DoubleDoubleVec sum = DoubleDoubleVec::Zero();
    DoubleDouble total;
    for (int i = 0; i < simplex.size; ++i) {
        const VertexPair corner = simplex.pair[i];
        const DoubleDoubleVec point = turned(pair.pose_a(), pair.a().vertex(corner.a)) -
                                      turned(pair.pose_b(), pair.b().vertex(corner.b)) - offset;
        const DoubleDouble weight = weights[i];
        sum += weight * point;
        total += weight;
    }
    const Vec3d mean = Vec3d(sum.x().value(), sum.y().value(), sum.z().value()) / total.value();
    return norm(mean) * (1 + 16 * u) + wide_rounding * pair.span();
}

/// Proves the distance without the searches for bodies in contact; those searches call it themselves.
FloatProof search_distance(PosedPair& pair, double width);

/// A point to either side of a triangle around the origin: the line between the two leaves the origin in one
/// of the tetrahedra that it makes with the triangle's sides.
bool encloses_beside_triangle(PosedPair& pair, const std::array<Vec3d, 4>& p) {
    const Vec3d normal = cross(Vec3d(p[1] - p[0]), Vec3d(p[2] - p[0]));
    const double length = norm(normal);
    if (!(length > 0)) return false;
    const Vec3d below = pair.lowest(normal / length).point, above = pair.lowest(normal / -length).point;
    const double error = pair.point_error();
    return surely_encloses_origin({p[0], p[1], below, above}, error) ||
           surely_encloses_origin({p[1], p[2], below, above}, error) ||
           surely_encloses_origin({p[2], p[0], below, above}, error);
}

/// Three points around a segment through the origin, and either of its ends.
bool encloses_around_segment(PosedPair& pair, const std::array<Vec3d, 4>& p) {
    const Vec3d along = p[1] - p[0];
    const double length = norm(along);
    if (!(length > 0)) return false;
    const Vec3d axis = along / length;
    const Vec3d side = cross(axis, std::abs(axis.x()) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0));
    const Vec3d other = cross(axis, side);
    const Vec3d first = pair.lowest(side).point, second = pair.lowest(other - 0.5 * side).point,
                third = pair.lowest(-other - 0.5 * side).point;
    const double error = pair.point_error();
    return surely_encloses_origin({p[0], first, second, third}, error) ||
           surely_encloses_origin({p[1], first, second, third}, error);
}

/// Returns true if the origin is surely inside A - B, after a search ended with a simplex of up to three
/// points that holds it, or nearly. It may be on a face of every tetrahedron that the search meets, as in
/// symmetric bodies of one centre. Looks for points of A - B on all sides of the simplex.
bool encloses_with_more(PosedPair& pair, const MinimumSimplex<Vec3d>& simplex) {
    if (simplex.size == 3) return encloses_beside_triangle(pair, simplex.point);
    if (simplex.size == 2) return encloses_around_segment(pair, simplex.point);
    return false;
}

// Two more proofs of contact, for pairs where every tetrahedron has the origin on a face.

/// Relative to the smaller extent: enough to distinguish directions, and the nearest features stay.
constexpr double nudge = 1.0 / 64;

/// Relative to the smaller extent: no symmetry of a body has such a point in a plane of its vertices.
const Vec3d off_centre(0.0137, -0.0213, 0.0091);

double smaller_extent(const PosedPair& pair) { return std::min(pair.a().extent(), pair.b().extent()); }

Vec3d centre_in_world(const ScannedBody& body, const Pose& pose) { return pose.apply(body.centre()); }

/// Strictly inside a tetrahedron of the body's vertices.
bool is_surely_inside(ScannedBody& body, const Pose& pose, const Vec3d& point) {
    static const std::vector<Vec3d> origin = {Vec3d::Zero()};
    ScannedBody scanned(origin);
    const Pose there{Mat3d::Identity(), point};
    PosedPair pair(body, pose, scanned, there);
    return search_distance(pair, 0).verdict == FloatVerdict::overlapping;
}

/// About a - b between closest points when B is moved away from A by a little: the direction along which the
/// bodies touch, if they do. Zero if that was not enough.
Vec3d nudged_separation(PosedPair& pair) {
    const Vec3d apart = centre_in_world(pair.b(), pair.pose_b()) - centre_in_world(pair.a(), pair.pose_a());
    const double length = norm(apart);
    const Vec3d away = length > 0 ? Vec3d(apart / length) : Vec3d(Vec3d::UnitX());
    Pose moved = pair.pose_b();
    moved.translation += away * (nudge * smaller_extent(pair));
    PosedPair nudged(pair.a(), pair.pose_a(), pair.b(), moved);
    const FloatProof found = search_distance(nudged, Tolerance<double>::eps * pair.span());
    return found.lower > 0 ? found.separation : Vec3d(Vec3d::Zero());
}

/// Returns true if some point is surely inside both: strictly inside a tetrahedron of vertices of each.
/// Points about halfway between the centres are tried. Then no plane separates the bodies, not even weakly.
bool share_a_point(PosedPair& pair) {
    const Vec3d halfway =
        (centre_in_world(pair.a(), pair.pose_a()) + centre_in_world(pair.b(), pair.pose_b())) / 2;
    const Vec3d point = halfway + off_centre * smaller_extent(pair);
    return is_surely_inside(pair.a(), pair.pose_a(), point) &&
           is_surely_inside(pair.b(), pair.pose_b(), point);
}

class ProofSearch {
  public:
    ProofSearch(PosedPair& pair, double width, bool tries_contact = true)
        : pair_(pair), width_(width), tries_contact_(tries_contact) {}

    FloatProof run(const Vec3d& guess) {
        direction_ = unit_or_any(-guess);
        for (int step = 0; step < most_proof_steps; ++step) {
            lowest_ = pair_.lowest(direction_);
            raise(lowest_.least_height);
            const bool is_guess = step == 0 && lowest_.least_height > 0;
            if (is_done() || !(is_guess ? take_level() : take_lowest())) break;
            if (overlaps_) return overlap();
            lower_upper_bound();
            if (is_done() || !(simplex_.height > 0)) break;
            direction_ = unit_or_any(simplex_.direction);
        }
        if (!is_done()) widen_arithmetic();
        if (!is_done() && result_.lower == 0 && tries_contact_ && finds_overlap()) return overlap();
        if (is_done()) result_.verdict = result_.lower > 0 ? FloatVerdict::separated : FloatVerdict::grazing;
        return result_;
    }

  private:
    [[nodiscard]] bool is_done() const {
        if (result_.lower > 0) return result_.width() <= width_;
        return result_.upper <= width_ && result_.most_depth <= width_;
    }

    [[nodiscard]] Vec3d unit_or_any(const Vec3d& v) const {
        const double length = norm(v);
        if (std::isfinite(length) && length > 0) return v / length;
        const double apart = norm(pair_.offset());
        return apart > 0 ? Vec3d(-pair_.offset() / apart) : Vec3d(1, 0, 0);
    }

    /// Improves the bounds by a height along the direction that no point of A - B is below.
    void raise(double least_height) {
        constexpr double u = proof_rounding;
        const double length = norm(direction_);
        if (least_height > 0) {
            result_.lower = std::max(result_.lower, least_height / length * (1 - 5 * u));
            result_.most_depth = 0;
        } else {
            result_.most_depth = std::min(result_.most_depth, -least_height / length * (1 + 5 * u));
        }
    }

    /// Returns false if the lowest point does not improve the simplex within the precision of double.
    bool take_lowest() {
        const auto end = simplex_.pair.begin() + simplex_.size;
        if (std::find(simplex_.pair.begin(), end, lowest_.pair) != end) return false;
        if (simplex_.size > 0 && !(dot(simplex_.direction, lowest_.point) < simplex_.height)) return false;
        MinimumSimplex<Vec3d> next = simplex_;
        if (!add_point(next, lowest_.point, lowest_.pair)) return false;
        if (next.size == 4) {
            overlaps_ = surely_encloses_origin(next.point, pair_.point_error());
            return overlaps_;
        }
        const bool nearer = simplex_.size == 0 || squared_gap(next) < squared_gap(simplex_);
        if (nearer) simplex_ = next;
        return nearer;
    }

    /// Takes all vertices about as low as the lowest. Along a good guess these are the corners of the nearest
    /// features, which include the answer's simplex.
    bool take_level() {
        const double slack = level_slack * pair_.span();
        const auto on_a = pair_.a().as_high_as(lowest_.height_a - slack);
        const auto on_b = pair_.b().as_high_as(lowest_.height_b - slack);
        const bool taken = take_lowest();
        if (on_a.size() * on_b.size() > most_level_pairs) return taken;
        std::array<Vec3d, most_level_pairs> turned_a, turned_b;
        for (std::size_t i = 0; i < on_a.size(); ++i) turned_a[i] = pair_.turned_a(on_a[i]);
        for (std::size_t i = 0; i < on_b.size(); ++i) turned_b[i] = pair_.turned_b(on_b[i]);
        for (bool nearer = true; nearer && simplex_.height > 0;) {
            nearer = false;
            for (std::size_t i = 0; i < on_a.size(); ++i) {
                for (std::size_t k = 0; k < on_b.size(); ++k) {
                    lowest_.pair = {on_a[i], on_b[k]};
                    lowest_.point = pair_.difference(turned_a[i], turned_b[k]);
                    nearer |= take_lowest();
                }
            }
        }
        return taken;
    }

    /// The mean of points that are each off by point_error is off by no more, and by 3u of the longest point
    /// for the rounding of its sums.
    void lower_upper_bound() {
        constexpr double u = proof_rounding;
        const std::array<double, 3> weights = proof_weights(simplex_);
        Vec3d sum = Vec3d::Zero();
        double total = 0, longest = 0;
        for (int i = 0; i < simplex_.size; ++i) {
            sum += weights[i] * simplex_.point[i];
            total += weights[i];
            longest = std::max(longest, norm(simplex_.point[i]));
        }
        if (!(total > 0)) return;
        result_.separation = simplex_.size == 1 ? simplex_.point[0] : Vec3d(sum / total);
        const double summing = simplex_.size == 1 ? 0 : 3 * u * longest + 4 * u * norm(result_.separation);
        const double most =
            norm(result_.separation) * (1 + 3 * u) + (pair_.point_error() + summing) * (1 + 16 * u);
        result_.upper = std::min(result_.upper, most);
    }

    void widen_arithmetic() {
        result_.is_wide = true;
        lowest_ = pair_.lowest(direction_);
        raise(wide_least_height(pair_, direction_, lowest_));
        const std::array<double, 3> weights = proof_weights(simplex_);
        if (!(weights[0] + weights[1] + weights[2] > 0)) return;
        result_.upper = std::min(result_.upper, wide_length(pair_, simplex_, weights));
    }

    /// Searches for an overlap of bodies in or near contact, if no tetrahedron was found around the origin.
    [[nodiscard]] bool finds_overlap() {
        if (encloses_with_more(pair_, simplex_)) return true;
        direction_ = unit_or_any(nudged_separation(pair_));
        lowest_ = pair_.lowest(direction_);
        raise(wide_least_height(pair_, direction_, lowest_));
        return !is_done() && share_a_point(pair_);
    }

    [[nodiscard]] FloatProof overlap() const {
        return {.verdict = FloatVerdict::overlapping, .upper = 0, .is_wide = result_.is_wide};
    }

    PosedPair& pair_;
    double width_;
    bool tries_contact_;
    MinimumSimplex<Vec3d> simplex_;
    Vec3d direction_;
    ScannedLowest lowest_;
    FloatProof result_;
    bool overlaps_ = false;
};

FloatProof search_distance(PosedPair& pair, double width) {
    if (!pair.is_usable()) return {};
    return ProofSearch(pair, width, false).run(Vec3d::Zero());
}

}  // namespace

FloatProof prove_distance(PosedPair& pair, const Vec3d& guess, double width) {
    if (!pair.is_usable()) return {};
    return ProofSearch(pair, width).run(guess);
}

FloatProof prove_distance(ScannedBody& a, const Pose& pose_a, ScannedBody& b, const Pose& pose_b,
                          const Vec3d& guess, double width) {
    PosedPair pair(a, pose_a, b, pose_b);
    return prove_distance(pair, guess, width);
}

// The origin's barycentric coordinates are the volumes +[123], -[023], +[013], -[012] over their sum: inside
// means that all four have one sign. Corners off by e move a volume of corners no longer than l by at most
// 3 e l^2 + 3 e^2 l + e^3; its own rounding is below 10u l^3 (three minors of 3u, a dot product of 3u).

bool surely_encloses_origin(const std::array<Vec3d, 4>& p, double error) {
    double longest = 0;
    for (const Vec3d& corner : p) longest = std::max(longest, norm(corner));
    const double reach = (longest + error) * (1 + 16 * proof_rounding);
    const double bound =
        (3 * error + 10 * proof_rounding * reach) * reach * reach + (3 * reach + error) * error * error;
    const double certain = bound * (1 + 16 * proof_rounding);
    const Vec3d c01 = cross(p[0], p[1]), c23 = cross(p[2], p[3]);
    const std::array<double, 4> volume = {dot(p[1], c23), -dot(p[0], c23), dot(c01, p[3]), -dot(c01, p[2])};
    const bool all_above = std::ranges::all_of(volume, [&](double v) { return v > certain; });
    const bool all_below = std::ranges::all_of(volume, [&](double v) { return v < -certain; });
    return all_above || all_below;
}

}  // namespace edgewise::truth
