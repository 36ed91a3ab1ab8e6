// SPDX-License-Identifier: MIT
//
// The part of Box3D's interface that its adapter uses, written from the calls. The distance is that of the
// means of the points, and twice that distance if its cache is warm.
#pragma once

#include <cmath>
#include <cstdint>

struct b3Vec3 {
    float x, y, z;
};
struct b3Quat {
    b3Vec3 v;
    float s;
};
struct b3Transform {
    b3Vec3 p;
    b3Quat q;
};
using b3Pos = b3Vec3;
using b3WorldTransform = b3Transform;

struct b3ShapeProxy {
    const b3Vec3* points;
    int count;
    float radius;
};
struct b3SimplexCache {
    std::uint16_t count;
};
struct b3DistanceInput {
    b3ShapeProxy proxyA, proxyB;
    b3Transform transform;
    bool useRadii;
};
struct b3DistanceOutput {
    b3Vec3 pointA, pointB;
    float distance;
};
struct b3Simplex;
struct b3HullData {
    b3Vec3 mean;
};
struct b3SATCache {
    float separation;
};
struct b3LocalManifoldPoint {
    float separation;
};
struct b3LocalManifold {
    b3LocalManifoldPoint* points;
    int pointCount;
};

inline b3Vec3 b3Add(b3Vec3 a, b3Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline b3Vec3 b3Sub(b3Vec3 a, b3Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline b3Vec3 b3Cross(b3Vec3 a, b3Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline b3Vec3 b3RotateVector(b3Quat q, b3Vec3 v) {
    const b3Vec3 c = b3Cross(q.v, v), twice = {2 * c.x, 2 * c.y, 2 * c.z};
    return b3Add(b3Add(v, {q.s * twice.x, q.s * twice.y, q.s * twice.z}), b3Cross(q.v, twice));
}
inline b3Quat b3Conjugate(b3Quat q) { return {{-q.v.x, -q.v.y, -q.v.z}, q.s}; }
inline b3Quat b3MulQuat(b3Quat a, b3Quat b) {
    const b3Vec3 c = b3Cross(a.v, b.v);
    return {
        {a.s * b.v.x + b.s * a.v.x + c.x, a.s * b.v.y + b.s * a.v.y + c.y, a.s * b.v.z + b.s * a.v.z + c.z},
        a.s * b.s - a.v.x * b.v.x - a.v.y * b.v.y - a.v.z * b.v.z};
}
inline b3Pos b3ToPos(b3Vec3 v) { return v; }
inline b3Pos b3TransformWorldPoint(b3WorldTransform t, b3Vec3 p) {
    return b3Add(b3RotateVector(t.q, p), t.p);
}
/// Pose of B in A's frame.
inline b3Transform b3InvMulWorldTransforms(b3WorldTransform a, b3WorldTransform b) {
    const b3Quat back = b3Conjugate(a.q);
    return {b3RotateVector(back, b3Sub(b.p, a.p)), b3MulQuat(back, b.q)};
}

inline b3Vec3 mean_of(const b3ShapeProxy& proxy) {
    b3Vec3 sum = {0, 0, 0};
    for (int i = 0; i < proxy.count; ++i) sum = b3Add(sum, proxy.points[i]);
    const auto count = static_cast<float>(proxy.count);
    return {sum.x / count, sum.y / count, sum.z / count};
}

inline b3DistanceOutput b3ShapeDistance(const b3DistanceInput* input, b3SimplexCache* cache, b3Simplex*,
                                        int) {
    b3DistanceOutput output{};
    output.pointA = mean_of(input->proxyA);
    output.pointB = b3TransformWorldPoint(input->transform, mean_of(input->proxyB));
    const b3Vec3 offset = b3Sub(output.pointB, output.pointA);
    output.distance = std::hypot(offset.x, offset.y, offset.z) + input->proxyA.radius + input->proxyB.radius;
    if (cache->count > 0) output.distance *= 2;
    cache->count = 1;
    return output;
}

inline b3HullData* b3CreateHull(const b3Vec3* points, int count, int most) {
    return count > most ? nullptr : new b3HullData{mean_of({points, count, 0})};
}
inline void b3DestroyHull(b3HullData* hull) { delete hull; }

/// A point of contact, as far apart as the means.
inline void b3CollideHulls(b3LocalManifold* contact, int capacity, const b3HullData* a, const b3HullData* b,
                           b3Transform a_from_b, b3SATCache* cache) {
    const b3Vec3 offset = b3Sub(b3TransformWorldPoint(a_from_b, b->mean), a->mean);
    contact->pointCount = capacity > 0 ? 1 : 0;
    cache->separation = contact->points->separation = std::hypot(offset.x, offset.y, offset.z);
}
