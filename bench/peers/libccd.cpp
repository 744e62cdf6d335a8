// libccd: GJK and EPA over support functions, in the precision that the package was built with. It has no distance of
// shapes that are apart.
#include <ccd/ccd.h>
#include <ccd/quat.h>

#include "peer.hpp"

struct Placed {
    const peer::Shape* shape;
    ccd_vec3_t position;
    ccd_quat_t rotation, inverse;
};

static void supportOf(const peer::Shape& shape, const ccd_vec3_t& d, ccd_vec3_t* point) {
    const ccd_real_t x = ccdVec3X(&d), y = ccdVec3Y(&d), z = ccdVec3Z(&d);
    switch (shape.kind) {
        case peer::Kind::Box:
            ccdVec3Set(point, std::copysign(shape.size[0], x), std::copysign(shape.size[1], y),
                       std::copysign(shape.size[2], z));
            return;
        case peer::Kind::Hull: {
            ccd_real_t most = -CCD_REAL_MAX;
            int best = 0;
            for (int i = 0, n = shape.cornerCount(); i < n; i++) {
                const float* c = &shape.corners[3 * i];
                ccd_real_t along = c[0] * x + c[1] * y + c[2] * z;
                if (along > most) {
                    most = along;
                    best = i;
                }
            }

            const float* c = &shape.corners[3 * best];
            ccdVec3Set(point, c[0], c[1], c[2]);
            return;
        }
        default: {
            ccd_vec3_t unit;
            ccdVec3Copy(&unit, &d);
            ccdVec3Normalize(&unit);
            ccdVec3Scale(&unit, shape.size[0]);
            ccd_real_t half = shape.kind == peer::Kind::Capsule ? std::copysign(shape.size[1], y) : 0;
            ccdVec3Set(point, ccdVec3X(&unit), ccdVec3Y(&unit) + half, ccdVec3Z(&unit));
        }
    }
}

static void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
    auto placed = static_cast<const Placed*>(object);
    ccd_vec3_t local;
    ccdVec3Copy(&local, direction);
    ccdQuatRotVec(&local, &placed->inverse);
    supportOf(*placed->shape, local, point);
    ccdQuatRotVec(point, &placed->rotation);
    ccdVec3Add(point, &placed->position);
}

class Libccd {
public:
    static constexpr bool takesSurfaces = false;

    bool can(peer::Verb verb, const peer::Scene&) const { return verb != peer::Verb::Distance; }

    void load(const peer::Scene& loaded) {
        scene = loaded;
        for (const peer::Pair& pair : scene.pairs) {
            placed.push_back(place(pair.a, pair.poseA));
            placed.push_back(place(pair.b, pair.poseB));
        }

        CCD_INIT(&settings);
        settings.support1 = settings.support2 = support;
        settings.max_iterations = 500;
    }

    peer::Answer ask(peer::Verb verb, size_t index) {
        const Placed* a = &placed[2 * index];
        const Placed* b = &placed[2 * index + 1];
        peer::Answer answer;
        if (verb == peer::Verb::Boolean) {
            answer.overlap = ccdGJKIntersect(a, b, &settings) != 0;
            answer.value = 0;
            return answer;
        }

        ccd_real_t depth;
        ccd_vec3_t direction, position;
        answer.overlap = ccdGJKPenetration(a, b, &settings, &depth, &direction, &position) == 0;
        if (answer.overlap) answer.value = depth;
        return answer;
    }

private:
    peer::Scene scene;
    std::vector<Placed> placed;
    ccd_t settings;

    Placed place(int32_t shape, const peer::Pose& pose) {
        Placed result;
        result.shape = &scene.shapes[shape];
        ccdVec3Set(&result.position, pose.position[0], pose.position[1], pose.position[2]);
        ccdQuatSet(&result.rotation, pose.rotation[0], pose.rotation[1], pose.rotation[2], pose.rotation[3]);
        ccdQuatInvert2(&result.inverse, &result.rotation);
        return result;
    }
};

int main() { return peer::main<Libccd>(); }
