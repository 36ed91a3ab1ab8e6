// SPDX-License-Identifier: MIT
//
// Records scenes of Bullet, at 240 steps per second: a stack of 100 boxes, a wall of 100 bricks that a crate
// hits, a heap of 200 hulls in a bin, with Bullet's margin of 0.04 around every hull or (heap0) without.
// Poses are those before a step, pairs those that its narrow phase took in the step. A box of Bullet contains
// its margin; the margin of a hull lies around it and is recorded as a radius.
//
// record_bullet SCENE [SECONDS [RATE]]: `edgewise record` calls it. At rate 0 every step is recorded.
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <edgewise/record.hpp>
#include <iostream>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using BulletRecorder = edgewise::Recorder<btScalar>;

constexpr btScalar time_step = btScalar(1) / 240;
constexpr btScalar brick[] = {0.5F, 0.25F, 0.25F};  ///< half extents

/// Random numbers, the same in every run.
class Random {
  public:
    btScalar uniform(btScalar low, btScalar high) {
        return low + (high - low) * static_cast<btScalar>(engine_() - engine_.min()) /
                         static_cast<btScalar>(engine_.max() - engine_.min());
    }
    btVector3 in_cube(btScalar half) {
        const btScalar x = uniform(-half, half), y = uniform(-half, half), z = uniform(-half, half);
        return {x, y, z};
    }
    btVector3 on_sphere() {
        const btScalar z = uniform(-1, 1), turn = uniform(0, 2 * std::numbers::pi_v<btScalar>);
        const btScalar r = std::sqrt(1 - z * z);
        return {r * std::cos(turn), r * std::sin(turn), z};
    }

  private:
    std::minstd_rand engine_;
};

BulletRecorder::Vector array_of(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

class BulletWorld {
  public:
    BulletWorld() { world_.setGravity({0, 0, btScalar(-9.81)}); }
    ~BulletWorld() {
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }
    BulletWorld(const BulletWorld&) = delete;
    BulletWorld& operator=(const BulletWorld&) = delete;

    btCollisionShape* keep(std::unique_ptr<btCollisionShape> shape) {
        return shapes_.emplace_back(std::move(shape)).get();
    }
    btCollisionShape* box(const btVector3& half) { return keep(std::make_unique<btBoxShape>(half)); }

    /// Mass 0: the body never moves.
    btRigidBody& add(btCollisionShape* shape, btScalar mass, const btVector3& place,
                     const btQuaternion& turn = btQuaternion::getIdentity()) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape->calculateLocalInertia(mass, inertia);
        btRigidBody& body =
            *bodies_.emplace_back(std::make_unique<btRigidBody>(mass, nullptr, shape, inertia));
        body.setWorldTransform(btTransform(turn, place));
        body.setUserIndex(static_cast<int>(bodies_.size()) - 1);
        world_.addRigidBody(&body);
        return body;
    }

    void record(double seconds, double rate) {
        BulletRecorder recorder(std::cout, "Bullet " + std::to_string(btGetVersion()), time_step,
                                edgewise::RecordedPairs::broad_phase);
        for (const auto& body : bodies_) add_to(recorder, *body);
        const long steps = std::lround(seconds / time_step);
        const long stride = rate > 0 ? std::max(1L, std::lround(1 / (rate * time_step))) : 1;
        for (long i = 0; i < steps; ++i) {
            std::vector<BulletRecorder::Pose> poses;
            std::vector<std::size_t> asleep;
            for (const auto& body : bodies_) {
                const btVector3& p = body->getCenterOfMassTransform().getOrigin();
                const btQuaternion q = body->getCenterOfMassTransform().getRotation();
                poses.push_back({p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()});
                if (!body->isActive()) asleep.push_back(poses.size() - 1);
            }
            world_.stepSimulation(time_step, 0);
            if (i % stride == 0)
                recorder.step({.time = static_cast<double>(i) * time_step,
                               .poses = poses,
                               .pairs = pairs(),
                               .asleep = asleep});
        }
    }

  private:
    std::size_t shape_of(btCollisionShape* shape, BulletRecorder& recorder) {
        const auto [known, is_new] = recorded_.try_emplace(shape, 0);
        if (!is_new) return known->second;
        if (const auto* box = dynamic_cast<const btBoxShape*>(shape))
            return known->second = recorder.add_box(array_of(box->getHalfExtentsWithMargin()));
        const auto& hull = dynamic_cast<const btConvexHullShape&>(*shape);
        std::vector<BulletRecorder::Vector> vertices;
        for (int i = 0; i < hull.getNumPoints(); ++i) vertices.push_back(array_of(hull.getScaledPoint(i)));
        return known->second = recorder.add_hull(vertices, hull.getMargin());
    }
    void add_to(BulletRecorder& recorder, btRigidBody& body) {
        recorder.add_body({.shape = shape_of(body.getCollisionShape(), recorder),
                           .link = static_cast<std::size_t>(body.getUserIndex()),
                           .fixed = body.isStaticObject()});
    }

    std::vector<BulletRecorder::Pair> pairs() {
        std::vector<BulletRecorder::Pair> pairs;
        const btBroadphasePairArray& found = world_.getPairCache()->getOverlappingPairArray();
        for (int i = 0; i < found.size(); ++i) {
            const auto* a = static_cast<const btCollisionObject*>(found[i].m_pProxy0->m_clientObject);
            const auto* b = static_cast<const btCollisionObject*>(found[i].m_pProxy1->m_clientObject);
            if (a->isActive() || b->isActive())  // else the narrow phase skips the pair
                pairs.push_back({static_cast<std::size_t>(a->getUserIndex()),
                                 static_cast<std::size_t>(b->getUserIndex())});
        }
        return pairs;
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broad_phase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::map<btCollisionShape*, std::size_t> recorded_;
};

void add_floor(BulletWorld& world, btScalar half) { world.add(world.box({half, half, 1}), 0, {0, 0, -1}); }

/// Ten towers of ten boxes, each box a little off.
void add_stack(BulletWorld& world, Random& random) {
    add_floor(world, 20);
    btCollisionShape* const box = world.box({0.5F, 0.5F, 0.5F});
    for (int i = 0; i < 100; ++i) {
        const btVector3 off = random.in_cube(0.02F);
        world.add(box, 1, {btScalar(i % 10) * 1.5F + off.x(), off.y(), 0.5F + btScalar(i / 10) * 1.01F});
    }
}

/// Ten rows of ten bricks, and the crate that hits them a second later.
void add_wall(BulletWorld& world, Random& /*random*/) {
    add_floor(world, 20);
    btCollisionShape* const box = world.box({brick[0], brick[1], brick[2]});
    for (int i = 0; i < 100; ++i) {
        const int row = i / 10;
        const btScalar x = (btScalar(i % 10) + (row % 2 == 0 ? 0 : 0.5F)) * 1.01F * 2 * brick[0];
        world.add(box, 1, {x, 0, brick[2] + btScalar(row) * 2 * brick[2]});
    }
    btRigidBody& crate = world.add(world.box({1, 1, 1}), 20, {5, -12, 1.5F});
    crate.setLinearVelocity({0, 12, 3});
}

/// 200 hulls of ten shapes, dropped into a bin.
void add_heap(BulletWorld& world, Random& random, bool with_margin) {
    constexpr btScalar half = 4;
    add_floor(world, 2 * half);
    btCollisionShape *const along_x = world.box({half, 0.5F, half}), *const along_y =
                                                                         world.box({0.5F, half, half});
    for (const btScalar side : {-half, half}) {
        world.add(along_x, 0, {0, side, half});
        world.add(along_y, 0, {side, 0, half});
    }
    std::vector<btConvexHullShape*> hulls;
    for (int shape = 0; shape < 10; ++shape) {
        auto hull = std::make_unique<btConvexHullShape>();
        const btVector3 axes = btVector3(0.45F, 0.45F, 0.45F) + random.in_cube(0.15F);
        const int vertices = 16 + static_cast<int>(random.uniform(0, 48.99F));
        for (int i = 0; i < vertices; ++i) hull->addPoint(random.on_sphere() * axes, false);
        hull->recalcLocalAabb();
        if (!with_margin) hull->setMargin(0);
        hulls.push_back(hull.get());
        world.keep(std::move(hull));
    }
    for (int i = 0; i < 200; ++i) {
        const btVector3 off = random.in_cube(0.3F);
        const btQuaternion turn(random.on_sphere(), random.uniform(0, 2 * std::numbers::pi_v<btScalar>));
        const btVector3 place(btScalar(i % 4) * 1.6F - 2.4F, btScalar(i / 4 % 4) * 1.6F - 2.4F,
                              1 + btScalar(i / 16) * 1.3F);
        const auto shape = static_cast<std::size_t>(random.uniform(0, 9.99F));
        world.add(hulls[shape], 1, place + off, turn);
    }
}

}  // namespace

int main(int count, char** words) {
    const std::string scene = count > 1 ? words[1] : "";
    BulletWorld world;
    Random random;
    if (scene == "stack")
        add_stack(world, random);
    else if (scene == "wall")
        add_wall(world, random);
    else if (scene == "heap" || scene == "heap0")
        add_heap(world, random, scene == "heap");
    else
        return std::fprintf(stderr, "usage: record_bullet stack|wall|heap|heap0 [SECONDS [RATE]]\n"), 2;
    world.record(count > 2 ? std::atof(words[2]) : 5, count > 3 ? std::atof(words[3]) : 60);
    return std::cout.flush() ? 0 : 1;
}
