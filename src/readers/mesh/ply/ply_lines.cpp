// ply_lines.cpp - reads the text of a PLY file in parts, by several threads.
#include "readers/mesh/ply/ply_lines.h"

#include <algorithm>
#include <cstring>

namespace firsthit {
namespace {

// Bytes; enough for several parts for each thread, and far more work than starting one.
constexpr std::size_t kPart = std::size_t(1) << 18;

/// A run of whole lines.
struct Part {
    const char* first = nullptr;
    const char* last = nullptr;
    std::size_t first_line = 0;
    std::size_t lines = 0;
};

std::vector<Part> split(std::string_view body, Tasks& tasks)
{
    const char* const end = body.data() + body.size();
    std::vector<Part> parts;
    for (const char* at = body.data(); at != end;) {
        const char* last = end;
        if (static_cast<std::size_t>(end - at) > kPart) {
            const void* const line_end =
                std::memchr(at + kPart, '\n', static_cast<std::size_t>(end - at) - kPart);
            if (line_end) last = static_cast<const char*>(line_end) + 1;
        }
        parts.push_back({at, last});
        at = last;
    }
    tasks.for_each(parts.size(), [&](std::size_t p, std::size_t) {
        parts[p].lines = static_cast<std::size_t>(std::count(parts[p].first, parts[p].last, '\n'));
    });
    if (!parts.empty() && end[-1] != '\n') ++parts.back().lines;
    for (std::size_t p = 1; p < parts.size(); ++p)
        parts[p].first_line = parts[p - 1].first_line + parts[p - 1].lines;
    return parts;
}

const char* skip_lines(const char* at, const char* end, std::size_t count)
{
    for (; count > 0; --count) {
        const void* const line_end = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
        if (!line_end) return end;
        at = static_cast<const char*>(line_end) + 1;
    }
    return at;
}

/// Calls read(source, first, last, part) for the elements of each part, whose lines begin at `line`.
/// returns  the end of the last one
template <class Read>
const char* read_parts(const std::vector<Part>& parts, std::size_t line, std::size_t count,
    Tasks& tasks, const Read& read)
{
    const char* const end = parts.back().last;
    const auto begins_after = [](std::size_t wanted, const Part& p) {
        return wanted < p.first_line;
    };
    const auto part_of = [&](std::size_t wanted) {
        return static_cast<std::size_t>(
            std::upper_bound(parts.begin(), parts.end(), wanted, begins_after) - parts.begin() - 1);
    };
    const std::size_t first = part_of(line);
    const std::size_t last = part_of(line + count - 1);
    const char* stop = nullptr;
    tasks.for_each(last - first + 1, [&](std::size_t number, std::size_t) {
        const Part& part = parts[first + number];
        const std::size_t from = std::max(part.first_line, line);
        const std::size_t to = std::min(part.first_line + part.lines, line + count);
        PlyLine source(skip_lines(part.first, end, from - part.first_line), end);
        read(source, from - line, to - line, number);
        if (first + number == last) stop = source.at();
    });
    return stop;
}

} // namespace

std::optional<std::size_t> read_ply_lines(
    std::string_view body, const PlyLinesJob& job, std::vector<PlyTriangles>& parts, Tasks& tasks)
{
    if (body.empty() || job.vertex.count == 0 || job.faces.count == 0) return {};
    const std::vector<Part> lines = split(body, tasks);
    const std::size_t total = lines.back().first_line + lines.back().lines;
    if (job.vertex.count > total || job.faces.count > total - job.vertex.count) return {};

    try {
        read_parts(lines, 0, job.vertex.count, tasks,
            [&](PlyLine& source, std::size_t first, std::size_t last, std::size_t) {
                for (std::size_t v = first; v < last; ++v) read_vertex(source, job.columns, v);
            });
        const PlyFaceElement element{job.faces, job.vertex.count};
        const bool has_uv = job.faces.has(PlyRole::texcoord);
        const bool colored = job.faces.has(PlyRole::red);
        std::vector<PlyTriangles> made(lines.size());
        const char* const stop = read_parts(lines, job.vertex.count, job.faces.count, tasks,
            [&](PlyLine& source, std::size_t first, std::size_t last, std::size_t part) {
                PlyTriangleMaker maker(job.position, has_uv, colored);
                maker.triangles.index.reserve(last - first);
                PlyFace face;
                for (std::size_t f = first; f < last; ++f) {
                    read_face(source, element, f, face);
                    maker.add(face, f);
                }
                made[part] = std::move(maker.triangles);
            });
        for (PlyTriangles& part : made) parts.push_back(std::move(part));
        return static_cast<std::size_t>(stop - body.data());
    } catch (const PlyOtherLines&) {
        return {};
    }
}

} // namespace firsthit
