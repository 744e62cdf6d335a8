// What every peer program shares: it reads pairs of shapes, answers them, and times whole passes over them when it is
// told to. The bench talks to it by lines: "load FILE", "can VERB", "turn VERB", "answers VERB", "quit".
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace peer {

enum class Kind : int32_t { Sphere = 0, Capsule = 1, Box = 2, Hull = 3, Surface = 4 };

enum class Verb { Distance, Boolean, Depth };

struct Shape {
    Kind kind;
    // Sphere: radius. Capsule (axis y): radius, half height without the caps. Box: half extents.
    float size[3];
    // Hull: corners, and triangles that are wound outward. Surface: the same, concave.
    std::vector<float> corners;
    std::vector<int32_t> triangles;

    int cornerCount() const { return static_cast<int>(corners.size() / 3); }
};

struct Pose {
    // x, y, z, w.
    float rotation[4];
    float position[3];
};

struct Pair {
    int32_t a, b;
    Pose poseA, poseB;
};

struct Scene {
    std::vector<Shape> shapes;
    std::vector<Pair> pairs;

    bool hasSurfaces() const {
        for (const Shape& shape : shapes)
            if (shape.kind == Kind::Surface) return true;
        return false;
    }
};

struct Answer {
    // Distance: >= 0, 0 when overlapping. Depth: the penetration depth. NaN: no answer.
    double value = std::numeric_limits<double>::quiet_NaN();
    bool overlap = false;
};

inline double checksum(const Answer& answer) {
    return (std::isfinite(answer.value) ? answer.value : 0) + (answer.overlap ? 1 : 0);
}

template <class T>
T read(std::istream& in) {
    T value;
    in.read(reinterpret_cast<char*>(&value), sizeof value);
    if (!in) throw std::runtime_error("the file of pairs ends early");
    return value;
}

template <class T>
std::vector<T> readMany(std::istream& in, int32_t count) {
    std::vector<T> values(static_cast<size_t>(count));
    in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(sizeof(T) * values.size()));
    if (!in) throw std::runtime_error("the file of pairs ends early");
    return values;
}

inline Pose readPose(std::istream& in) {
    Pose pose;
    for (float& r : pose.rotation) r = read<float>(in);
    for (float& p : pose.position) p = read<float>(in);
    return pose;
}

inline Scene readScene(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in || read<int32_t>(in) != 0x31504a47) throw std::runtime_error(file + " is no file of pairs");
    Scene scene;
    for (int32_t left = read<int32_t>(in); left > 0; left--) {
        Shape shape;
        shape.kind = static_cast<Kind>(read<int32_t>(in));
        for (float& s : shape.size) s = read<float>(in);
        shape.corners = readMany<float>(in, 3 * read<int32_t>(in));
        shape.triangles = readMany<int32_t>(in, 3 * read<int32_t>(in));
        scene.shapes.push_back(std::move(shape));
    }

    for (int32_t left = read<int32_t>(in); left > 0; left--) {
        Pair pair;
        pair.a = read<int32_t>(in);
        pair.b = read<int32_t>(in);
        pair.poseA = readPose(in);
        pair.poseB = readPose(in);
        scene.pairs.push_back(pair);
    }

    return scene;
}

// The loop of a peer. Engine: constexpr bool takesSurfaces, bool can(Verb, const Scene&), void load(const Scene&),
// Answer ask(Verb, size_t pair).
template <class Engine>
class Program {
public:
    int run() {
        std::string word;
        while (std::cin >> word && word != "quit") {
            std::string argument;
            std::cin >> argument;
            if (word == "load") load(argument);
            else if (word == "can") std::cout << (engine && engine->can(verbOf(argument), scene) ? "yes" : "no") << std::endl;
            else if (word == "turn") std::cout << turn(verbOf(argument)) << std::endl;
            else if (word == "answers") answers(verbOf(argument));
            else throw std::runtime_error("unknown word " + word);
        }

        return 0;
    }

private:
    // As the bench's own loops: a turn takes at least three samples and four milliseconds, or one long sample.
    static constexpr int leastSamples = 3;
    static constexpr double turnSeconds = 0.004, longSeconds = 0.04;

    Scene scene;
    std::unique_ptr<Engine> engine;
    volatile double sink = 0;

    static Verb verbOf(const std::string& word) {
        if (word == "distance") return Verb::Distance;
        if (word == "boolean") return Verb::Boolean;
        if (word == "depth") return Verb::Depth;
        throw std::runtime_error("unknown verb " + word);
    }

    void load(const std::string& file) {
        engine.reset();
        scene = readScene(file);
        if (Engine::takesSurfaces || !scene.hasSurfaces()) {
            engine = std::make_unique<Engine>();
            engine->load(scene);
        }

        std::cout << "loaded" << std::endl;
    }

    double sample(Verb verb) {
        auto start = std::chrono::steady_clock::now();
        double sum = 0;
        for (size_t i = 0; i < scene.pairs.size(); i++) sum += checksum(engine->ask(verb, i));
        double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        sink = sink + sum;
        return seconds;
    }

    double turn(Verb verb) {
        double best = std::numeric_limits<double>::infinity(), total = 0;
        for (int samples = 0; !isOver(samples, total); samples++) {
            double seconds = sample(verb);
            total += seconds;
            best = std::min(best, seconds);
        }

        return best * 1e9 / static_cast<double>(scene.pairs.size());
    }

    static bool isOver(int samples, double total) {
        return (samples >= leastSamples && total >= turnSeconds) || (samples > 0 && total >= samples * longSeconds);
    }

    void answers(Verb verb) {
        std::cout.precision(9);
        for (size_t i = 0; i < scene.pairs.size(); i++) {
            Answer answer = engine->ask(verb, i);
            std::cout << (answer.overlap ? 1 : 0) << ' ' << answer.value << '\n';
        }

        std::cout << std::flush;
    }
};

template <class Engine>
int main() {
    try {
        return Program<Engine>().run();
    } catch (const std::exception& e) {
        std::cerr << e.what() << std::endl;
        return 1;
    }
}

}  // namespace peer
