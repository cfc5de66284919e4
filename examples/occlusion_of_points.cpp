// occlusion_of_points.cpp - hours of sun on a facade that another house stands in front of.
#include <firsthit/firsthit.h>

#include <cmath>
#include <cstdio>

int main()
{
    // x is east, y up, z south. The facade is the plane z = 0 and looks south; the house is 10 m wide, 12 m
    // high, and stands 6 m in front of it. Only what throws shadows has to be in the scene.
    std::vector<glm::vec3> position;
    for (unsigned corner = 0; corner < 8; ++corner)
        position.emplace_back(corner & 1 ? 5 : -5, corner & 2 ? 12 : 0, corner & 4 ? 14 : 6);
    std::vector<glm::uvec3> index;
    for (const glm::uvec4 f : {glm::uvec4(0, 2, 3, 1), {4, 5, 7, 6}, {0, 4, 6, 2}, {1, 3, 7, 5},
             {0, 1, 5, 4}, {2, 6, 7, 3}}) {
        index.emplace_back(f.x, f.y, f.z);
        index.emplace_back(f.x, f.z, f.w);
    }
    firsthit::World world;
    firsthit::pose(firsthit::scene_from_arrays(position, index), 0, world);

    // A point for each half metre of the facade, 40 m x 10 m, row by row from below.
    constexpr std::size_t kColumns = 80;
    constexpr std::size_t kRows = 20;
    std::vector<glm::vec3> points;
    for (std::size_t row = 0; row < kRows; ++row)
        for (std::size_t column = 0; column < kColumns; ++column)
            points.emplace_back(0.5f * float(column) - 19.75f, 0.5f * float(row) + 0.25f, 0);

    // The sun every ten minutes of an equinox at 50 degrees north: from the east, over the south, to the west.
    std::vector<firsthit::Light> suns;
    for (int minute = 6 * 60 + 10; minute < 18 * 60; minute += 10) {
        const double hour_angle = (minute / 60.0 - 12) * 15 * 3.14159265358979 / 180;
        const glm::dvec3 to_sun(
            -std::sin(hour_angle), std::cos(hour_angle) * 0.6428, std::cos(hour_angle) * 0.7660);
        suns.push_back({.kind = firsthit::Light::Kind::directional, .direction = -to_sun});
    }

    std::vector<double> hours(points.size());
    firsthit::Occlusion occlusion;
    occlusion.test(world, points, suns, [&](std::size_t, std::span<const std::uint8_t> occluded) {
        for (std::size_t p = 0; p < occluded.size(); ++p) hours[p] += occluded[p] ? 0 : 1.0 / 6;
    });

    // A house that stands on the ground shades what is low more than what is high.
    bool right = true;
    for (std::size_t row = kRows; row-- > 0;) {
        for (std::size_t column = 0; column < kColumns; column += 4)
            std::printf("%5.1f", hours[row * kColumns + column]);
        std::printf(" hours, %5.2f m up\n", double(points[row * kColumns].y));
        for (std::size_t column = 0; row > 0 && column < kColumns; ++column)
            right = right && hours[row * kColumns + column] >= hours[(row - 1) * kColumns + column];
    }
    return right && hours[kColumns / 2] < 8 && hours.back() > 11 ? 0 : 1;
}
