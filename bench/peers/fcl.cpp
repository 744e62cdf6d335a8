// FCL: distance and collide of fcl::Convex, Box, Sphere and Capsule in double, with its own GJK solver where there is a
// choice, since the other is libccd's; of surfaces with its trees of oriented boxes and swept spheres.
#include <fcl/fcl.h>

#include "peer.hpp"

class Fcl {
public:
    static constexpr bool takesSurfaces = true;

    bool can(peer::Verb verb, const peer::Scene& scene) const {
        if (scene.hasSurfaces() && verb == peer::Verb::Depth) return false;
        for (const peer::Shape& shape : scene.shapes)
            if (shape.kind == peer::Kind::Hull && shape.triangles.empty()) return false;
        return true;
    }

    void load(const peer::Scene& scene) {
        for (const peer::Shape& shape : scene.shapes) shapes.push_back(make(shape));
        for (const peer::Pair& pair : scene.pairs) {
            pairs.push_back(pair);
            transforms.push_back(transformOf(pair.poseA, scene.shapes[pair.a]));
            transforms.push_back(transformOf(pair.poseB, scene.shapes[pair.b]));
        }

        collide.gjk_solver_type = fcl::GST_INDEP;
        depth.gjk_solver_type = fcl::GST_INDEP;
        depth.enable_contact = true;
        distance.gjk_solver_type = fcl::GST_INDEP;
        distance.enable_nearest_points = true;
        distance.distance_tolerance = 1e-9;
    }

    peer::Answer ask(peer::Verb verb, size_t index) {
        const peer::Pair& pair = pairs[index];
        const fcl::CollisionGeometryd* a = shapes[pair.a].get();
        const fcl::CollisionGeometryd* b = shapes[pair.b].get();
        const fcl::Transform3d& atA = transforms[2 * index];
        const fcl::Transform3d& atB = transforms[2 * index + 1];
        peer::Answer answer;
        if (verb == peer::Verb::Distance) {
            fcl::DistanceResultd result;
            fcl::distance(a, atA, b, atB, distance, result);
            answer.overlap = result.min_distance <= 0;
            answer.value = answer.overlap ? 0 : result.min_distance;
            return answer;
        }

        fcl::CollisionResultd result;
        answer.overlap = fcl::collide(a, atA, b, atB, verb == peer::Verb::Depth ? depth : collide, result) > 0;
        if (verb == peer::Verb::Boolean) answer.value = 0;
        // This solver gives depths a negative sign, the one for boxes a positive one.
        else if (answer.overlap && result.numContacts() > 0)
            answer.value = std::fabs(result.getContact(0).penetration_depth);
        return answer;
    }

private:
    std::vector<std::shared_ptr<fcl::CollisionGeometryd>> shapes;
    std::vector<peer::Pair> pairs;
    std::vector<fcl::Transform3d, Eigen::aligned_allocator<fcl::Transform3d>> transforms;
    fcl::CollisionRequestd collide, depth;
    fcl::DistanceRequestd distance;

    // A capsule's axis is z there and y here.
    static fcl::Transform3d transformOf(const peer::Pose& pose, const peer::Shape& shape) {
        const float* q = pose.rotation;
        fcl::Transform3d transform = fcl::Transform3d::Identity();
        transform.linear() = fcl::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
        transform.translation() = fcl::Vector3d(pose.position[0], pose.position[1], pose.position[2]);
        if (shape.kind == peer::Kind::Capsule) {
            fcl::Matrix3d zToY;
            zToY << 1, 0, 0, 0, 0, 1, 0, -1, 0;
            transform.linear() *= zToY;
        }

        return transform;
    }

    static std::shared_ptr<fcl::CollisionGeometryd> make(const peer::Shape& shape) {
        const float* s = shape.size;
        switch (shape.kind) {
            case peer::Kind::Sphere:
                return std::make_shared<fcl::Sphered>(s[0]);
            case peer::Kind::Capsule:
                return std::make_shared<fcl::Capsuled>(s[0], 2.0 * s[1]);
            case peer::Kind::Box:
                return std::make_shared<fcl::Boxd>(2.0 * s[0], 2.0 * s[1], 2.0 * s[2]);
            case peer::Kind::Surface: {
                std::vector<fcl::Vector3d> corners;
                for (int i = 0; i < shape.cornerCount(); i++) {
                    const float* c = &shape.corners[3 * i];
                    corners.emplace_back(c[0], c[1], c[2]);
                }

                std::vector<fcl::Triangle> triangles;
                for (size_t i = 0; i < shape.triangles.size(); i += 3)
                    triangles.emplace_back(shape.triangles[i], shape.triangles[i + 1], shape.triangles[i + 2]);
                auto surface = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
                surface->beginModel();
                surface->addSubModel(corners, triangles);
                surface->endModel();
                return surface;
            }
            default: {
                auto corners = std::make_shared<std::vector<fcl::Vector3d>>();
                for (int i = 0; i < shape.cornerCount(); i++) {
                    const float* c = &shape.corners[3 * i];
                    corners->emplace_back(c[0], c[1], c[2]);
                }

                auto faces = std::make_shared<std::vector<int>>();
                for (size_t i = 0; i < shape.triangles.size(); i += 3) {
                    faces->push_back(3);
                    for (int k = 0; k < 3; k++) faces->push_back(shape.triangles[i + k]);
                }

                return std::make_shared<fcl::Convexd>(corners, static_cast<int>(shape.triangles.size() / 3), faces);
            }
        }
    }
};

int main() { return peer::main<Fcl>(); }
