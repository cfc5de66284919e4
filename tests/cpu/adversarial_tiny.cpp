// adversarial_tiny.cpp - triangles about as large as a pixel, made to meet what kernels for them get
// wrong.
#include "cpu/adversarial_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firsthit::test {

using glm::vec3;

void add_tiny_scenes(std::vector<AdversarialScene>& scenes)
{
    const auto add = [&](std::string name, auto fill) {
        scenes.push_back({std::move(name), fill});
    };

    add("half pixel mesh with vertices on pixel centres", [](TestWorld& w, std::mt19937& r) {
        add_grid(w, r, 40,
            [](int i, int j) { return at(float(i) * .5f - 9.5f, float(j) * .5f - 9.5f, 3); });
    });
    add("half pixel mesh within rounding of pixel centres", [](TestWorld& w, std::mt19937& r) {
        add_grid(w, r, 40, [&](int i, int j) {
            const float z = uniform(r, 3, 3.01f);
            return at(float(i) * .5f - 9.5f, float(j) * .5f - 9.5f, z);
        });
    });
    add("three pixel mesh with vertices on pixel centres", [](TestWorld& w, std::mt19937& r) {
        add_grid(w, r, 14, [&](int i, int j) {
            return at(float(3 * i) - 20.5f, float(3 * j) - 20.5f, float(3 * whole(r, 1, 2)));
        });
    });
    add("folded mesh", [](TestWorld& w, std::mt19937& r) {
        add_grid(w, r, 36, [&](int i, int j) {
            return at(float(i) - 18 + uniform(r, -1, 1), float(j) - 18 + uniform(r, -1, 1),
                4 + uniform(r, -.002f, .002f));
        });
    });
    add("fans of needles inside two by two pixels", [](TestWorld& w, std::mt19937& r) {
        for (int fan = 0; fan < 6; ++fan) {
            // Around a pixel centre, or a corner of four.
            const float x = float(whole(r, -20, 20)) + (fan & 1 ? .5f : 0);
            const float y = float(whole(r, -20, 20)) + (fan & 1 ? .5f : 0);
            const auto rim = [&](int k) {
                const float a = 6.2831853f * float(k) / 90;
                return at(
                    x + .95f * std::cos(a), y + .95f * std::sin(a), 3 + .01f * std::sin(7 * a));
            };
            for (int k = 0; k < 90; ++k) w.add(at(x, y, 3), rim(k), rim((k + 1) % 90));
        }
    });
    add("tiny coplanar duplicates", [](TestWorld& w, std::mt19937& r) {
        // Points of x / 4 + y / 8 + z = 4 with few bits, a third of a pixel apart.
        for (int k = 0; k < 150; ++k) {
            const int i = whole(r, -28, 28), j = whole(r, -28, 28);
            std::array<vec3, 3> p;
            for (vec3& v : p) {
                const float x = float(i + whole(r, 0, 3)) / 32, y = float(j + whole(r, 0, 3)) / 32;
                v = vec3(x, y, 4 - x / 4 - y / 8);
            }
            for (int copy = 0; copy < 3; ++copy) {
                std::shuffle(p.begin(), p.end(), r);
                w.add(p[0], p[1], p[2]);
            }
        }
        std::shuffle(w.scene->index.begin(), w.scene->index.end(), r);
    });
    add("tiny triangles at all depths", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 900; ++k) {
            // Beyond 2^30 and below 2^-30 other kernels take over.
            const float z = std::pow(2.0f, k % 3 == 0   ? float(whole(r, -31, -29))
                                           : k % 3 == 1 ? float(whole(r, 29, 31))
                                                        : uniform(r, -40, 40));
            const float x = uniform(r, -22, 22), y = uniform(r, -22, 22);
            const auto p = [&] {
                return at(x + uniform(r, -1, 1), y + uniform(r, -1, 1), z * uniform(r, 1, 1.01f));
            };
            w.add(p(), p(), p());
        }
    });
    add("tiny triangles that are long in depth", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 600; ++k) {
            const float x = uniform(r, -22, 22), y = uniform(r, -22, 22);
            const float most = std::pow(2.0f, uniform(r, -12, 12));
            const auto p = [&] {
                return at(
                    x + uniform(r, -.9f, .9f), y + uniform(r, -.9f, .9f), uniform(r, 1, 1 + most));
            };
            w.add(p(), p(), p());
        }
    });
    add("tiny triangles a hair before a full layer", [](TestWorld& w, std::mt19937& r) {
        w.add(at(-200, -200, 4), at(200, -200, 4), at(0, 200, 4));
        for (int k = 0; k < 700; ++k) {
            const float z = 4 - 4 * std::pow(2.0f, float(-whole(r, 12, 23)));
            const float x = uniform(r, -22, 22), y = uniform(r, -22, 22), half = uniform(r, .2f, 1);
            w.add(at(x - half, y - half, z), at(x + half, y - half, z), at(x, y + half, z));
        }
    });
    add("tiny triangles in each other's way", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 900; ++k) {
            const float x = float(whole(r, -6, 6)) * .5f, y = float(whole(r, -6, 6)) * .5f;
            const auto p = [&] {
                return at(x + uniform(r, -1.5f, 1.5f), y + uniform(r, -1.5f, 1.5f),
                    4 * (1 + float(whole(r, -6, 6)) * 0x1p-22f));
            };
            w.add(p(), p(), p());
        }
    });
    add("tiny triangles across the picture's border", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 500; ++k) {
            const float along = uniform(r, -26, 26), across = 24 + uniform(r, -2, 2);
            const float x = k & 1 ? along : k & 2 ? across : -across;
            const float y = k & 1 ? (k & 2 ? across : -across) : along;
            const auto p = [&] {
                return at(
                    x + uniform(r, -1.5f, 1.5f), y + uniform(r, -1.5f, 1.5f), uniform(r, 4, 4.02f));
            };
            w.add(p(), p(), p());
        }
        // Corners far outside, a box of few samples inside.
        for (int k = 0; k < 60; ++k) {
            const float reach = std::pow(10.0f, uniform(r, 0, 6));
            w.add(at(-24 - reach, -24, 4), at(-24, -24 - reach, 4),
                at(-24 + uniform(r, 0, 2), -24 + uniform(r, 0, 2), 4));
        }
    });
    add("degenerate tiny triangles", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 200; ++k) {
            const float x = float(whole(r, -20, 20)) + .5f, y = float(whole(r, -20, 20)) + .5f;
            const vec3 a = at(x - .5f, y - .5f, 3), b = at(x + .5f, y + .5f, 3);
            w.add(a, b, a);
            w.add(a, b, at(x, y, 3));
            w.add(a, b, at(x, y + std::pow(2.0f, -uniform(r, 10, 30)), 3));
        }
    });
}

} // namespace firsthit::test
