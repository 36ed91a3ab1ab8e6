// SPDX-License-Identifier: MIT
//
// Every epsilon of Edgewise, and the one cap on a loop, each with its unit and its reason. No other file
// holds a literal tolerance.
#pragma once

#include <limits>

namespace edgewise {

struct DoubleDouble;

/// Tolerances by scalar type that computes; multiples of its rounding step, so they scale with the body.
template <class Scalar>
struct Tolerance {
    /// Rounding step: 2^-52 or 2^-23.
    static constexpr Scalar eps = std::numeric_limits<Scalar>::epsilon();

    /// V-Clip, relative slope (pure number): an edge counts as "towards the plane" only when its slope
    /// exceeds this. Without the band, rounding noise on an edge parallel to the face looks like an escape
    /// and the local-minimum test is skipped: a loop at identical orientations. A true slope below it costs
    /// the distance as much, so it must stay near the noise of one product: 64 eps was 4e-5 of scale in
    /// single on nearly parallel cubes, 8 is 8e-6.
    static constexpr Scalar towards_plane = 8 * eps;

    /// V-Clip, relative slope (pure number): the derivative of the distance from an edge to a vertex counts
    /// as zero inside this band, since the directions of parallel edges are rounded. It costs the distance as
    /// much times the edge's length.
    static constexpr Scalar vertex_derivative = 4 * eps;

    /// Edge-edge closest points, squared sine of the angle: edges that cross at more than 1/16 rad lose at
    /// most four binary digits of a parameter, which the distance does not feel; flatter ones take the
    /// careful way.
    static constexpr Scalar fair_crossing = Scalar(1) / 256;

    /// GJK, relative to |v| max|w|: the rounding noise of the support products.
    static constexpr Scalar support_noise = 4 * eps;

    /// GJK, relative to |v| max|w|: the duality gap that an answer may leave open: that noise in double, half
    /// of it in single, since thin boxes were off by up to six steps otherwise, and doubles, which compute
    /// again what remains open, cost little.
    static constexpr Scalar open_gap = (eps < Scalar(1e-10) ? 4 : 2) * eps;

    /// Support climbing, relative to |direction| and the largest coordinate: vertices that differ by less in
    /// height may be as high as each other. Two heights of three products each, and how far a climbable body
    /// is from convex (bent_face), on either side: 18 + 28.
    static constexpr Scalar level = 64 * eps;

    /// Exact oracle, absolute, in units where a body and a direction are about 1: proven bound of the error
    /// of a vertex height computed in floating point (derived in truth/exact_body.cpp).
    static constexpr Scalar support_filter = 256 * eps;

    /// Radians, by the scalar that stores: faces or sides that turn by less count as flat, and V-Clip proves
    /// its answers on such a body. Under an edge that turns by t, planes with noise n distinguish the two
    /// sides from a depth of n / t on: a millionth of the size in double (2^-26), a quarter in single, where
    /// a larger value would include spheres of some hundred vertices.
    static constexpr Scalar strict_turn = eps < Scalar(1e-10) ? Scalar(0x1p-26) : 64 * eps;

    /// Johnson, squared height over length of a triangle: below it the direction of the normal is off by more
    /// than a thousandth.
    static constexpr Scalar sliver = (1024 * eps) * (1024 * eps);

    /// Johnson, squared height over length of a triangle: below it the foot is computed in wider
    /// arithmetic. The normal is off by the rounding over the height, the distance by that times the size:
    /// 2^-44 in double, 2^-18 in single, some rounding steps below what a query may err (verified_error).
    static constexpr Scalar thin = eps < Scalar(1e-10) ? Scalar(0x1p-16) : Scalar(0x1p-10);

    /// Johnson, relative to the permanent (the triple product with all signs positive): rounding of a triple
    /// product of differences. A tetrahedron with a corner volume not beyond it is flat.
    static constexpr Scalar volume_noise = 8 * eps;

    /// GJK, relative to max|w|: the bodies are in contact if the closest point is nearer to the origin than
    /// this, cannot be improved, and its direction separates nothing.
    static constexpr Scalar contact_noise = 16 * eps;

    /// V-Clip, relative to the size: features that meet to within this are in contact. In double half of the
    /// verdict band (verdict_band_steps): rounding of the computed distance has the other half. In single
    /// nothing: such answers are computed again in doubles, which takes little time.
    static constexpr Scalar meeting = eps < Scalar(1e-10) ? 8 * eps : 0;

    /// Normal of a face, squared sine of the angle at a corner: above it the plain cross product loses at
    /// most four binary digits; thinner corners take an exact one, or one in wider arithmetic.
    static constexpr Scalar fair_corner = Scalar(1) / 256;

    /// Plane through a side of a face, squared sine of the angle at a corner: it may be tilted about the side
    /// by the rounding over the sine, 2^-42 in double and 2^-17 in single. It moves a point's foot by that
    /// times the height, less than a query may err (verified_error), and the distance by the square of it.
    static constexpr Scalar tilting_corner = eps < Scalar(1e-10) ? Scalar(0x1p-20) : Scalar(0x1p-12);

    /// Sides of a face, relative to the body's largest coordinate: rounding its two ends to this scalar, half
    /// a step each, turns a side of this length by a sixty-fourth at most, so that a fair corner stays one;
    /// at a shorter side a corner may be as thin as rounding made it.
    static constexpr Scalar rounded_side = 64 * eps;

    /// V-Clip, relative to the size: closest points nearer than this have a direction accurate to a part in
    /// 256 at best, and slopes along it, which decide, are no better.
    static constexpr Scalar hardly_apart = 256 * contact_noise;

    /// Limit of a query, in the bodies' own unit: origins farther from each other than this are refused,
    /// since the square of the distance must not overflow: 2^510 in double (3e153), 2^62 in single (5e18).
    static constexpr Scalar largest_offset = eps < Scalar(1e-10) ? Scalar(0x1p510) : Scalar(0x1p62);

    /// Relative to max|w|: a closest point nearer to the origin than this is computed in the next wider
    /// arithmetic once an answer without it was not proven; V-Clip's answer on slippery features is computed
    /// again by GJK. Its direction is off by the rounding of the points over
    /// their distance from the origin, and the distance by that times the size: beyond a thousandth of the
    /// size in double, 1/16 in single, neither exceeds what a query may err (verified_error).
    static constexpr Scalar close = eps < Scalar(1e-10) ? Scalar(0x1p-10) : Scalar(0x1p-4);

    /// GJK, relative to max|w|: a closest point nearer to the origin than this has a direction accurate to a
    /// part in 256 at best, which proves nothing: it is computed in wider arithmetic at once.
    static constexpr Scalar hardly_close = 1024 * eps;
};

/// Tolerances for sums of two doubles: only those that the sub-distance uses.
template <>
struct Tolerance<DoubleDouble> {
    static constexpr double eps = 0x1p-100;
    static constexpr double sliver = (1024 * eps) * (1024 * eps);
    static constexpr double thin = 0x1p-80;  ///< cofactors are off by eps of the sides
    static constexpr double volume_noise = 8 * eps;
};

/// V-Clip, relative to the size, where planes are stored in single and computed with in double: a vertex that
/// a plane's rounding of 2^-24 leaves outside its feature's region makes the distance d too long by 2^-49 /
/// d.
inline constexpr double close_of_rounded_planes = 0x1p-7;

/// Relative to the extent: how far a vertex may lie off the plane of its face, or above the plane of another,
/// in a body that counts as sound. Qhull merges what it cannot distinguish, which leaves a few dozen rounding
/// steps; beyond 4096 (1e-12) a face is bent, not rounded.
inline constexpr double face_planarity = 4096 * std::numeric_limits<double>::epsilon();

/// Relative to the largest coordinate: a vertex farther off the plane of its face than rounding leaves it (1
/// on every named shape) is a corner that neither planes nor climbs see. Half of the verdict's band.
inline constexpr double bent_face = 8 * std::numeric_limits<double>::epsilon();

/// Radians times lengths of the edge, relative to the largest coordinate: an edge that seems to turn outwards
/// by less may turn inwards, because planes have some rounding steps of noise.
inline constexpr double climbable_turn = 64 * std::numeric_limits<double>::epsilon();

/// Relative to the extent: a body thinner than this is flat. Equal to face_planarity, since below it no check
/// can distinguish the two sides of the body.
inline constexpr double flat_thickness = face_planarity;

/// Relative to the longest axis: V-Clip proves its answers on a solid thinner than this, as on one that is
/// not strictly convex. An edge may lie in a face of such a body, or two faces may cross, to within the noise
/// of its planes over its thickness: 1.4 million answers at 1e-11 to 1e-5 were 334 times wrong in double, at
/// up to 3e-6.
inline constexpr double thin_solid = 0x1p-16;

/// Twice the area of a corner of a polygon in axes scaled to about 1: below some rounding steps it is
/// straight.
inline constexpr double straight_corner = 8 * std::numeric_limits<double>::epsilon();

/// Relative to the extent: faces given in single precision are bent by its rounding, and quads are no longer
/// plane. Up to eight rounding steps, the hull of their vertices replaces the faces.
inline constexpr double single_planarity = 8 * 0x1p-23;

/// Pure number: how far from orthogonal rounding may leave a rotation that was computed in double.
inline constexpr double rotation_rounding = 64 * std::numeric_limits<double>::epsilon();

/// Pure number, the root of squared_rotation_error (algorithms/answerable.hpp): a query's rotation farther
/// from a proper one is refused. A matrix typed with two digits is within it; one that scales by a hundredth
/// is not.
inline constexpr double sloppiest_rotation = 0x1p-5;

/// Pure number: V-Clip uses the transpose of R as its inverse, and passes a rotation farther from orthogonal
/// than this to GJK, which does not. Nearer ones cost a distance some multiple of this times the size
/// (sloppy_steps), which is less than `close` in double.
inline constexpr double sloppy_rotation = 0x1p-14;

/// V-Clip, times R's distance from orthogonal and the size: below this distance the two frames may disagree
/// on which features are closest.
inline constexpr double sloppy_steps = 16;

/// Pure number, the largest entry of |R^T R - I| of a rotation in an input (scene/nearest_rotation.hpp): up
/// to the first limit it is used as given; up to the second, which is three digits typed with care, the
/// nearest rotation replaces it; farther away it is refused.
inline constexpr double written_rotation_rounding = 1e-12;
inline constexpr double sloppiest_written_rotation = 1e-3;

/// Relative to the largest coordinate: the rounding of a plane's offset far from the origin.
inline constexpr double offset_rounding = 4 * std::numeric_limits<double>::epsilon();

/// Relative to the largest coordinate: the rounding of a distance from a plane of unit normal and of how far
/// a box reaches above it, together.
inline constexpr double box_rounding = 32 * std::numeric_limits<double>::epsilon();

/// Relative to the offset and the half extents of two boxes, and to the length of the direction: the rounding
/// of how far their shadows on it are apart.
inline constexpr double box_axis_rounding = std::numeric_limits<double>::epsilon();

/// Pure number: how far the length of a unit normal may be from 1.
inline constexpr double unit_length = 8 * std::numeric_limits<double>::epsilon();

/// Coordinates beyond largest_coordinate, and bodies narrower than smallest_extent (in the body's own unit),
/// are refused: products of four coordinates, and the low halves of their sums of two doubles, must neither
/// overflow nor vanish.
inline constexpr double largest_coordinate = 1e60;
inline constexpr double smallest_extent = 1e-60;

/// Largest coordinate for storage in single precision, once the larger body is scaled to about 1
/// (bench/length_scale.hpp).
inline constexpr double largest_coordinate_single = 0x1p30;
inline constexpr double smallest_extent_single = 0x1p-30;

/// EPA, where bodies are about 1: a coordinate below this counts as zero, so that every digit of a product of
/// three differences stays in the range of double (3 x (200 + 53) < 1074 binary places).
inline constexpr double smallest_coordinate = 0x1p-200;

/// A cap on GJK's iterations per query, which ends without it: every iteration lowers the distance by more
/// than rounding, or ends the run; spheres of 1538 vertices take up to some dozen. A thousandfold of that is
/// a tenth of a second. Only a shape that breaks its contract reaches the cap: an assertion in debug; in
/// release the query reports that it failed.
inline constexpr int most_gjk_iterations = 1 << 14;

/// A cap on the steps of a GJK query that gain nothing even in wider arithmetic, taken while nothing
/// separates the bodies, so that they end. The pair that showed the need took two.
inline constexpr int most_level_steps = 32;

/// Pure number: a mesh is called concave when its volume is below this share of its hull's. Mesh files hold
/// about seven digits, so a convex mesh of thousands of faces is off by some 1e-6.
inline constexpr double convex_volume_share = 1 - 1e-4;

/// Relative to the body's size: how near to the wanted distance a scene places a pair. Scenes need a spread
/// of distances, not exact ones; every finer digit costs distance evaluations.
inline constexpr double placement_tolerance = 1e-4;

/// Relative to the body's size: placement tolerance of the scene `gap`, which is about its gaps. Half of it
/// is for the search, half for cutting offsets of up to 16 sizes to 24 bits (2^-25 x 16 = 4.8e-7).
inline constexpr double gap_placement_tolerance = 1e-6;

/// Verdict band (truth/accuracy_band.hpp), in rounding steps of the scale of a pair: a gap or a depth inside
/// it is below the precision. About the steps of a pose, a rotated vertex and a plane together.
inline constexpr double verdict_band_steps = 16;

/// Verdict band, times the distance of R from orthogonal and the extent: how far R_A^T R_B instead of R as
/// given may move a vertex, over three rows and both bodies.
inline constexpr double verdict_band_ortho = 4;

/// Verification, relative to the scale of a pair: the error of a distance, and of the distance of its witness
/// points, beyond which a cell fails. Some thousand rounding steps in double and some eighty in single; the
/// worst measured are a few of either.
inline constexpr double verified_error_double = 1e-12;
inline constexpr double verified_error_single = 1e-5;

/// Verified error of depths in double, larger than of distances: a normal is less accurate than a foot.
inline constexpr double verified_depth_error_double = 1e-9;

/// Judged error of other libraries, relative to the scale of a pair, distances and depths: their own aim
/// (1e-6 is FCL's distance_tolerance and Coal's). An error below it is by their design.
inline constexpr double judged_error_peer = 1e-6;

}  // namespace edgewise
