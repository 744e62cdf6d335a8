// ODE: dCollide of boxes, spheres and capsules, in the precision that the package was built with. It tells whether they
// touch and how deep; it has no distance, and its convex against convex is left out as its authors call it unfinished.
#include <ode/ode.h>

#include "peer.hpp"

class Ode {
public:
    Ode() { dInitODE2(0); }

    ~Ode() {
        for (dGeomID geom : geoms) dGeomDestroy(geom);
        dCloseODE();
    }

    static constexpr bool takesSurfaces = false;

    bool can(peer::Verb verb, const peer::Scene& scene) const {
        for (const peer::Shape& shape : scene.shapes)
            if (shape.kind == peer::Kind::Hull) return false;
        return verb != peer::Verb::Distance;
    }

    void load(const peer::Scene& scene) {
        for (const peer::Pair& pair : scene.pairs) {
            place(scene.shapes[pair.a], pair.poseA);
            place(scene.shapes[pair.b], pair.poseB);
        }
    }

    peer::Answer ask(peer::Verb verb, size_t index) {
        peer::Answer answer;
        int most = verb == peer::Verb::Boolean ? 1 : mostContacts;
        int count = dCollide(geoms[2 * index], geoms[2 * index + 1], most, contacts, sizeof(dContactGeom));
        answer.overlap = count > 0;
        if (verb == peer::Verb::Boolean) answer.value = 0;
        for (int i = 0; i < count; i++)
            if (!(answer.value >= contacts[i].depth)) answer.value = contacts[i].depth;
        return answer;
    }

private:
    static constexpr int mostContacts = 8;
    std::vector<dGeomID> geoms;
    dContactGeom contacts[mostContacts];

    void place(const peer::Shape& shape, const peer::Pose& pose) {
        const float* s = shape.size;
        const float* q = pose.rotation;
        dGeomID geom = nullptr;
        if (shape.kind == peer::Kind::Hull) return;
        if (shape.kind == peer::Kind::Sphere) geom = dCreateSphere(nullptr, s[0]);
        else if (shape.kind == peer::Kind::Box) geom = dCreateBox(nullptr, 2 * s[0], 2 * s[1], 2 * s[2]);
        else geom = dCreateCapsule(nullptr, s[0], 2 * s[1]);
        dQuaternion turn = {q[3], q[0], q[1], q[2]};
        if (shape.kind == peer::Kind::Capsule) {
            // A capsule's axis is z there and y here: turn by -90 degrees about x first.
            const dQuaternion zToY = {M_SQRT1_2, -M_SQRT1_2, 0, 0};
            dQuaternion own = {turn[0], turn[1], turn[2], turn[3]};
            dQMultiply0(turn, own, zToY);
        }

        dGeomSetQuaternion(geom, turn);
        dGeomSetPosition(geom, pose.position[0], pose.position[1], pose.position[2]);
        // Else the first query would move it.
        dGeomGetRotation(geom);
        geoms.push_back(geom);
    }
};

int main() { return peer::main<Ode>(); }
