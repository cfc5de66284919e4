// occlusion_tables.cpp - answers of `firsthit occlusion` as CSV.
#include "occlusion_tables.h"

#include <firsthit/file.h>

#include <fmt/format.h>

#include <iterator>

namespace firsthit::cli {

void write_hours_csv(
    const std::string& path, std::span<const glm::vec3> points, std::span<const double> hours)
{
    std::string text = "x,y,z,hours\n";
    for (std::size_t k = 0; k < points.size(); ++k)
        fmt::format_to(std::back_inserter(text), "{},{},{},{:.4f}\n", points[k].x, points[k].y,
            points[k].z, hours[k]);
    write_file(path, text);
}

void write_answers_csv(const std::string& path, std::span<const glm::vec3> points,
    std::span<const std::uint8_t> bits, std::size_t lights)
{
    const std::size_t bytes = (points.size() + 7) / 8;
    std::string text = "x,y,z";
    for (std::size_t light = 0; light < lights; ++light) text += fmt::format(",{}", light);
    text += '\n';
    for (std::size_t k = 0; k < points.size(); ++k) {
        fmt::format_to(std::back_inserter(text), "{},{},{}", points[k].x, points[k].y, points[k].z);
        for (std::size_t light = 0; light < lights; ++light) {
            text += ',';
            text += bits[light * bytes + k / 8] >> (k % 8) & 1 ? '1' : '0';
        }
        text += '\n';
    }
    write_file(path, text);
}

} // namespace firsthit::cli
