// rays.cpp - what any rays hit.
#include "arrays.h"
#include "bindings.h"
#include "interpreter.h"
#include "numbers.h"
#include "posed.h"

#include <firsthit/error.h>
#include <firsthit/ray_caster.h>

#include <cstring>
#include <mutex>
#include <string>
#include <vector>

namespace firsthit::python {
namespace {

namespace py = pybind11;

template <class T>
py::array_t<T> filled(const std::vector<T>& values)
{
    py::array_t<T> result(py::ssize_t(values.size()));
    if (!values.empty())
        std::memcpy(result.mutable_data(), values.data(), values.size() * sizeof(T));
    return result;
}

/// t, triangle, instance (N), uv (N, 2) and normal (N, 3).
py::dict hit_arrays(const std::vector<RayHit>& hits, const std::vector<std::uint32_t>& owner)
{
    const auto count = py::ssize_t(hits.size());
    py::array_t<float> t(count), uv({count, py::ssize_t(2)}), normal({count, py::ssize_t(3)});
    py::array_t<std::uint32_t> triangle(count), instance(count);
    float *const to_t = t.mutable_data(), *const to_uv = uv.mutable_data(),
                 *const to_normal = normal.mutable_data();
    std::uint32_t *const to_triangle = triangle.mutable_data(), *const to_instance =
                                                                    instance.mutable_data();
    for (std::size_t k = 0; k < hits.size(); ++k) {
        const RayHit& hit = hits[k];
        to_t[k] = hit.t;
        to_triangle[k] = hit.triangle;
        to_instance[k] = hit.triangle == kNoItem ? kNoItem : owner[hit.triangle];
        to_uv[2 * k] = hit.u;
        to_uv[2 * k + 1] = hit.v;
        for (int axis = 0; axis < 3; ++axis)
            to_normal[3 * k + std::size_t(axis)] = hit.normal[axis];
    }
    py::dict all;
    all["t"] = t;
    all["triangle"] = triangle;
    all["instance"] = instance;
    all["uv"] = uv;
    all["normal"] = normal;
    return all;
}

/// Rays as Python gives them: origins and directions (N, 3), least and greatest t (N, 2), and None or ids (N).
std::vector<Ray> rays_of(const py::object& origins, const py::object& directions,
    const py::object& limits, const py::object& skip)
{
    const std::vector<glm::vec3> from = vectors3(origins, "origins"),
                                 along = vectors3(directions, "directions");
    const std::vector<glm::vec2> range = vectors2(limits, "tmin, tmax");
    const std::vector<std::uint32_t> skipped = ids(skip, "skip");
    if (along.size() != from.size() || range.size() != from.size() ||
        (!skip.is_none() && skipped.size() != from.size()))
        throw ArgumentError("origins, directions, skip, tmin and tmax are not of one shape");
    std::vector<Ray> rays(from.size());
    for (std::size_t k = 0; k < rays.size(); ++k)
        rays[k] = {
            from[k], along[k], range[k].x, range[k].y, skipped.empty() ? kNoItem : skipped[k]};
    return rays;
}

/// A RayCaster for one thread at a time.
class PythonRayCaster {
  public:
    explicit PythonRayCaster(const py::object& threads) : caster_(thread_count(threads)) {}

    py::dict nearest(PosedWorld& world, const py::object& origins, const py::object& directions,
        const py::object& limits, const py::object& skip)
    {
        const std::vector<Ray> rays = rays_of(origins, directions, limits, skip);
        std::vector<RayHit> hits;
        work(world, [&] { caster_.nearest(world.world, rays, hits); });
        return hit_arrays(hits, world.world.scene->owner);
    }

    py::array occluded(PosedWorld& world, const py::object& origins, const py::object& directions,
        const py::object& limits, const py::object& skip)
    {
        const std::vector<Ray> rays = rays_of(origins, directions, limits, skip);
        std::vector<std::uint8_t> occluded;
        work(world, [&] { caster_.occluded(world.world, rays, occluded); });
        py::array_t<bool> result(py::ssize_t(occluded.size()));
        bool* const out = result.mutable_data();
        for (std::size_t k = 0; k < occluded.size(); ++k) out[k] = occluded[k] != 0;
        return result;
    }

    py::array count(PosedWorld& world, const py::object& origins, const py::object& directions,
        const py::object& limits, const py::object& skip)
    {
        const std::vector<Ray> rays = rays_of(origins, directions, limits, skip);
        std::vector<std::uint32_t> count;
        work(world, [&] { caster_.count(world.world, rays, count); });
        return filled(count);
    }

    /// Also `first` (N + 1), uint64.
    py::dict all_hits(PosedWorld& world, const py::object& origins, const py::object& directions,
        const py::object& limits, const py::object& skip)
    {
        const std::vector<Ray> rays = rays_of(origins, directions, limits, skip);
        RayHitLists lists;
        work(world, [&] { caster_.all_hits(world.world, rays, lists); });
        py::dict all = hit_arrays(lists.hit, world.world.scene->owner);
        all["first"] = filled(std::vector<std::uint64_t>(lists.first.begin(), lists.first.end()));
        return all;
    }

    int threads() const { return caster_.threads(); }

    std::pair<std::uint64_t, std::uint64_t> updates() const
    {
        const RayCaster::Updates updates = caster_.updates();
        return {updates.builds, updates.refits};
    }

  private:
    template <class Work>
    void work(PosedWorld& world, const Work& cast)
    {
        const Unlocked unlocked;
        const std::lock_guard turn(turn_);
        const std::shared_lock lock(world.use);
        cast();
    }

    RayCaster caster_;
    std::mutex turn_;
};

} // namespace

void add_rays(py::module_& module)
{
    py::class_<PythonRayCaster>(module, "RayCaster",
        "Casts rays at worlds, and keeps a tree over their triangles between calls.")
        .def(py::init<const py::object&>(), py::arg("threads") = 0)
        .def_property_readonly("threads", &PythonRayCaster::threads)
        .def_property_readonly("updates",
            [](const PythonRayCaster& self) {
                const auto [builds, refits] = self.updates();
                return py::make_tuple(builds, refits);
            })
        .def("_nearest", &PythonRayCaster::nearest)
        .def("_occluded", &PythonRayCaster::occluded)
        .def("_count", &PythonRayCaster::count)
        .def("_all_hits", &PythonRayCaster::all_hits);
}

} // namespace firsthit::python
