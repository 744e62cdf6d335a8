// Bullet: GJK with its EPA where shapes overlap, in float, through btGjkPairDetector, without margins where a shape can
// do without.
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "peer.hpp"

class Bullet {
public:
    static constexpr bool takesSurfaces = false;

    bool can(peer::Verb, const peer::Scene&) const { return true; }

    void load(const peer::Scene& scene) {
        for (const peer::Shape& shape : scene.shapes) shapes.push_back(make(shape));
        for (const peer::Pair& pair : scene.pairs) {
            pairs.push_back(pair);
            transforms.push_back(transformOf(pair.poseA));
            transforms.push_back(transformOf(pair.poseB));
        }
    }

    peer::Answer ask(peer::Verb verb, size_t index) {
        const peer::Pair& pair = pairs[index];
        btConvexShape* a = shapes[pair.a].get();
        btConvexShape* b = shapes[pair.b].get();
        btGjkPairDetector::ClosestPointInput input;
        input.m_transformA = transforms[2 * index];
        input.m_transformB = transforms[2 * index + 1];
        btGjkPairDetector detector(a, b, &simplex, verb == peer::Verb::Depth ? &epa : nullptr);
        btPointCollector points;
        detector.getClosestPoints(input, points, nullptr);
        peer::Answer answer;
        if (!points.m_hasResult) {
            // Without a solver for depths, overlapping shapes have no result.
            answer.overlap = verb != peer::Verb::Depth;
            if (answer.overlap) answer.value = 0;
            return answer;
        }

        answer.overlap = points.m_distance <= 0;
        answer.value = verb == peer::Verb::Depth ? -points.m_distance : points.m_distance;
        return answer;
    }

private:
    std::vector<std::unique_ptr<btConvexShape>> shapes;
    std::vector<peer::Pair> pairs;
    std::vector<btTransform> transforms;
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver epa;

    static btTransform transformOf(const peer::Pose& pose) {
        const float* q = pose.rotation;
        return btTransform(
            btQuaternion(q[0], q[1], q[2], q[3]), btVector3(pose.position[0], pose.position[1], pose.position[2]));
    }

    static std::unique_ptr<btConvexShape> make(const peer::Shape& shape) {
        switch (shape.kind) {
            case peer::Kind::Sphere:
                return std::make_unique<btSphereShape>(shape.size[0]);
            case peer::Kind::Capsule:
                return std::make_unique<btCapsuleShape>(shape.size[0], 2 * shape.size[1]);
            case peer::Kind::Box: {
                auto box = std::make_unique<btBoxShape>(btVector3(shape.size[0], shape.size[1], shape.size[2]));
                box->setMargin(0);
                return box;
            }
            default: {
                auto hull = std::make_unique<btConvexHullShape>();
                for (int i = 0; i < shape.cornerCount(); i++) {
                    const float* c = &shape.corners[3 * i];
                    hull->addPoint(btVector3(c[0], c[1], c[2]), false);
                }

                hull->setMargin(0);
                hull->recalcLocalAabb();
                return hull;
            }
        }
    }
};

int main() { return peer::main<Bullet>(); }
