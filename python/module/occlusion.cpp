// occlusion.cpp - which points lights do not reach, and how much of the sky does.
#include "arrays.h"
#include "bindings.h"
#include "interpreter.h"
#include "numbers.h"
#include "posed.h"

#include <firsthit/occlusion.h>
#include <firsthit/sky.h>

#include <pybind11/stl.h>

#include <cstring>
#include <mutex>
#include <vector>

namespace firsthit::python {
namespace {

namespace py = pybind11;

/// An Occlusion for one thread at a time.
class PythonOcclusion {
  public:
    explicit PythonOcclusion(const py::object& threads) : occlusion_(thread_count(threads)) {}

    /// returns  bool (L, N), or with `packed` uint8 (L, ceil(N / 8)), bit k of byte j for point 8 j + k
    py::array test(PosedWorld& world, const py::object& points, const std::vector<Light>& lights,
        const py::object& receivers, bool packed)
    {
        const std::vector<glm::vec3> at = vectors3(points, "points");
        const std::vector<std::uint32_t> on = ids(receivers, "receivers");
        const auto count = py::ssize_t(at.size()), number = py::ssize_t(lights.size());
        if (packed) {
            std::vector<std::uint8_t> bits;
            {
                const Unlocked unlocked;
                const std::lock_guard turn(turn_);
                const std::shared_lock lock(world.use);
                occlusion_.test_packed(world.world, at, lights, bits, on);
            }
            py::array_t<std::uint8_t> result({number, (count + 7) / 8});
            if (!bits.empty()) std::memcpy(result.mutable_data(), bits.data(), bits.size());
            return result;
        }
        py::array_t<bool> result({number, count});
        bool* out = result.mutable_data();
        const Unlocked unlocked;
        const std::lock_guard turn(turn_);
        const std::shared_lock lock(world.use);
        occlusion_.test(
            world.world, at, lights,
            [&](std::size_t light, std::span<const std::uint8_t> occluded) {
                for (std::size_t k = 0; k < occluded.size(); ++k)
                    out[light * at.size() + k] = occluded[k] != 0;
            },
            on);
        return result;
    }

    /// returns  float32 (N, 3)
    py::array sky(PosedWorld& world, const py::object& points, const py::object& normals,
        const Sky& sky, const py::object& receivers)
    {
        const std::vector<glm::vec3> at = vectors3(points, "points"),
                                     up = vectors3(normals, "normals");
        const std::vector<std::uint32_t> on = ids(receivers, "receivers");
        std::vector<glm::vec3> light;
        {
            const Unlocked unlocked;
            const std::lock_guard turn(turn_);
            const std::shared_lock lock(world.use);
            sky_light(occlusion_, world.world, sky, {at, up, on}, light);
        }
        py::array_t<float> result({py::ssize_t(light.size()), py::ssize_t(3)});
        if (!light.empty())
            std::memcpy(result.mutable_data(), light.data(), light.size() * sizeof(glm::vec3));
        return result;
    }

  private:
    Occlusion occlusion_;
    std::mutex turn_;
};

} // namespace

void add_occlusion(py::module_& module)
{
    py::class_<PythonOcclusion>(
        module, "Occlusion", "Tests points against lights, and keeps memory between tests.")
        .def(py::init<const py::object&>(), py::arg("threads") = 0)
        .def("_test", &PythonOcclusion::test)
        .def("_sky", &PythonOcclusion::sky);
}

} // namespace firsthit::python
