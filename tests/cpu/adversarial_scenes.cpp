// adversarial_scenes.cpp - triangles that break rasterisers which are only nearly right.
#include "cpu/adversarial_points.h"
#include "cpu/adversarial_scenes.h"

#include <algorithm>
#include <array>

namespace firsthit::test {
namespace {

using glm::vec3;

std::vector<AdversarialScene> make_scenes()
{
    std::vector<AdversarialScene> scenes;
    const auto add = [&](std::string name, auto fill) {
        scenes.push_back({std::move(name), fill});
    };

    add("random triangles", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 60; ++k) w.add(random_at(r), random_at(r), random_at(r));
    });
    add("small random triangles", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 600; ++k) {
            const vec3 p = random_at(r);
            const auto near_p = [&] {
                return p +
                       vec3(uniform(r, -.1f, .1f), uniform(r, -.1f, .1f), uniform(r, -.1f, .1f));
            };
            w.add(near_p(), near_p(), near_p());
        }
    });
    add("vertices on pixel centres, one plane", [](TestWorld& w, std::mt19937& r) {
        add_grid(w, r, 20, [](int i, int j) { return at(float(i) - 9.5f, float(j) - 9.5f, 4); });
    });
    add("vertices within rounding of pixel centres", [](TestWorld& w, std::mt19937& r) {
        add_grid(w, r, 20,
            [&](int i, int j) { return at(float(i) - 9.5f, float(j) - 9.5f, uniform(r, 2, 5)); });
    });
    add("integer vertices, many ties", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 200; ++k) {
            const auto p = [&] {
                return at(float(whole(r, -12, 12)) * 2 + .5f, float(whole(r, -12, 12)) * 2 + .5f,
                    float(whole(r, 1, 4)));
            };
            w.add(p(), p(), p());
        }
    });
    add("slivers", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 300; ++k) {
            const vec3 a = random_at(r), b = random_at(r);
            w.add(a, b, a + (b - a) * uniform(r, 0, 1) + vec3(uniform(r, -1e-5f, 1e-5f)));
        }
    });
    add("a fan of needles around a pixel centre", [](TestWorld& w, std::mt19937& r) {
        const vec3 hub = at(0.5f, -0.5f, uniform(r, 2, 4));
        std::vector<vec3> rim;
        const int n = 700;
        for (int k = 0; k < n; ++k) {
            const float a = 6.2831853f * float(k) / float(n);
            rim.push_back(at(20 * std::cos(a), 20 * std::sin(a), uniform(r, 2, 4)));
        }
        const auto first = std::uint32_t(w.world.position.size());
        w.world.position.push_back(hub);
        w.world.position.insert(w.world.position.end(), rim.begin(), rim.end());
        for (int k = 0; k < n; ++k)
            w.scene->index.push_back(
                {first, first + 1 + std::uint32_t(k), first + 1 + std::uint32_t((k + 1) % n)});
    });
    add("duplicates and permuted duplicates", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 40; ++k) {
            std::array<vec3, 3> p{random_at(r), random_at(r), random_at(r)};
            for (int copy = 0; copy < 4; ++copy) {
                std::shuffle(p.begin(), p.end(), r);
                w.add(p[0], p[1], p[2]);
            }
        }
        std::shuffle(w.scene->index.begin(), w.scene->index.end(), r);
    });
    add("coplanar overlaps", [](TestWorld& w, std::mt19937& r) {
        // Points of x / 4 + y / 8 + z = 4 with few bits: exactly in one plane.
        for (int k = 0; k < 120; ++k) {
            const auto p = [&] {
                const float x = float(whole(r, -32, 32)) / 16, y = float(whole(r, -32, 32)) / 16;
                return vec3(x, y, 4 - x / 4 - y / 8);
            };
            w.add(p(), p(), p());
        }
    });
    add("nearly coplanar layers", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 100; ++k) {
            const float z = 4 * (1 + float(whole(r, -8, 8)) * 0x1p-22f);
            const auto p = [&] { return at(uniform(r, -30, 30), uniform(r, -30, 30), z); };
            w.add(p(), p(), p());
        }
    });
    add("interpenetrating triangles", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 80; ++k)
            w.add(random_at(r, 25, 3.9f, 4.1f), random_at(r, 25, 3.9f, 4.1f),
                random_at(r, 25, 3.9f, 4.1f));
    });
    add("through and around the eye", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 60; ++k) {
            const auto p = [&] {
                return vec3(uniform(r, -2, 2), uniform(r, -2, 2), uniform(r, -2, 2));
            };
            w.add(p(), p(), p());
        }
    });
    add("the eye in the triangle's plane", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 120; ++k) {
            // Two directions span a plane through the eye; the third corner is nearly in it.
            const vec3 a = random_at(r), b = random_at(r);
            const float s = uniform(r, -1, 2), t = uniform(r, -1, 2);
            const float off = k % 3 == 0 ? 0.0f : uniform(r, -1e-6f, 1e-6f);
            w.add(a, b, s * a + t * b + vec3(0, off, 0));
        }
        for (int k = 0; k < 20; ++k) { // exactly in it: the plane y = 0, and x = z
            w.add({uniform(r, -3, 3), 0, uniform(r, -3, 3)},
                {uniform(r, -3, 3), 0, uniform(r, -3, 3)},
                {uniform(r, -3, 3), 0, uniform(r, -3, 3)});
        }
    });
    add("a vertex at the eye", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 40; ++k) w.add({0, 0, 0}, random_at(r), random_at(r));
        for (int k = 0; k < 10; ++k) w.add(random_at(r), random_at(r), random_at(r));
    });
    add("on the plane of the eye", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 60; ++k) {
            const auto flat = [&] { return vec3(uniform(r, -1, 1), uniform(r, -1, 1), 0); };
            if (k & 1)
                w.add(flat(), flat(), random_at(r));
            else
                w.add(flat(), random_at(r), random_at(r));
        }
    });
    add("a grazing ground under a horizon", [](TestWorld& w, std::mt19937& r) {
        add_grid(w, r, 12, [&](int i, int j) {
            return vec3(
                float(i - 6) * 300, 1e-3f + 1e-5f * float(whole(r, 0, 3)), float(j) * 400 - 100);
        });
    });
    add("huge and tiny together", [](TestWorld& w, std::mt19937& r) {
        w.add({-3e11f, -1e5f, 2e11f}, {3e11f, -1e5f, 2e11f}, {0, 3e11f, 2e11f});
        w.add({-3e5f, 3e5f, 1e5f}, {3e5f, 3e5f, 1e5f}, {0, -3e5f, 1e6f});
        for (int k = 0; k < 200; ++k) {
            const float z = std::pow(10.0f, uniform(r, -6, 6));
            const auto p = [&] { return at(uniform(r, -24, 24), uniform(r, -24, 24), z); };
            w.add(p(), p(), p());
        }
    });
    add("tiny scale", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 100; ++k)
            w.add(1e-20f * random_at(r), 1e-20f * random_at(r), 1e-20f * random_at(r));
    });
    add("so near that 1/t overflows", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 90; ++k) {
            const float scale = std::pow(2.0f, -uniform(r, 118, 136));
            const float half = k % 3 == 0 ? 1.0f : 30.0f;
            const vec3 p = at(uniform(r, -20, 20), uniform(r, -20, 20), 1);
            const auto near_p = [&] { return scale * (p + random_at(r, half)); };
            w.add(near_p(), near_p(), near_p());
        }
    });
    add("degenerate triangles", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 60; ++k) {
            const vec3 a = random_at(r), b = random_at(r);
            w.add(a, b, a);
            w.add(a, a, a);
            w.add(a, b, 0.5f * (a + b));
        }
        w.add(random_at(r), random_at(r), random_at(r));
    });
    add("one triangle over many", [](TestWorld& w, std::mt19937& r) {
        add_grid(w, r, 90, [&](int i, int j) {
            return at(float(i - 45) * .6f, float(j - 45) * .6f, uniform(r, 4, 4.001f));
        });
        w.add(at(-100, -100, 3), at(100, -100, 3), at(0, 200, 3));
        w.add(at(-100, -100, 5), at(100, -100, 5), at(0, 200, 5));
    });
    add("small triangles a hair before a full layer", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 80; ++k) w.add(at(-200, -200, 4), at(200, -200, 4), at(0, 200, 4));
        for (int k = 0; k < 400; ++k) {
            const float z = 4 - 4 * std::pow(2.0f, float(-whole(r, 9, 21)));
            const float x = uniform(r, -22, 22), y = uniform(r, -22, 22), half = uniform(r, .5f, 3);
            w.add(at(x - half, y - half, z), at(x + 2 * half, y - half, z), at(x, y + 2 * half, z));
        }
    });
    add("large triangles a hair before a full layer", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 80; ++k) w.add(at(-200, -200, 4), at(200, -200, 4), at(0, 200, 4));
        for (int k = 0; k < 40; ++k) {
            const float z = 4 - 4 * std::pow(2.0f, float(-whole(r, 9, 21)));
            const float x = uniform(r, -22, 22), y = uniform(r, -22, 22), half = uniform(r, 9, 20);
            w.add(at(x - half, y - half, z), at(x + 2 * half, y - half, z), at(x, y + 2 * half, z));
        }
    });
    add("grazing grounds a hair apart", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 40; ++k) {
            const float y = 1 + float(whole(r, -16, 16)) * 0x1p-18f, tilt = 0.01f;
            const auto ground = [&](float x, float z) { return vec3(x, y + tilt * x, z); };
            w.add(ground(-20000, uniform(r, 1, 4)), ground(20000, uniform(r, 1, 4)),
                ground(uniform(r, -500, 500), uniform(r, 200000, 900000)));
        }
    });
    add("a far triangle between near corners", [](TestWorld& w, std::mt19937&) {
        // The blocks in the picture's corners hide the last triangle, those between do not.
        for (int k = 0; k < 80; ++k) {
            const float x = k & 1 ? 30.0f : -30.0f, y = k & 2 ? 30.0f : -30.0f;
            w.add(at(x, y, 2), at(x, y / 15, 2), at(x / 15, y, 2));
        }
        w.add(at(-200, -200, 5), at(200, -200, 5), at(0, 200, 5));
    });
    add("many layers, far ones first", [](TestWorld& w, std::mt19937& r) {
        for (int k = 0; k < 60; ++k) {
            const float z = 20 - 0.3f * float(k);
            w.add(at(uniform(r, -60, 0), uniform(r, -60, 0), z),
                at(uniform(r, 0, 60), -30, z * 1.05f), at(uniform(r, -30, 30), 60, z * .95f));
        }
    });
    add_tiny_scenes(scenes);
    return scenes;
}

} // namespace

const std::vector<AdversarialScene>& adversarial_scenes()
{
    static const std::vector<AdversarialScene> scenes = make_scenes();
    return scenes;
}

} // namespace firsthit::test
