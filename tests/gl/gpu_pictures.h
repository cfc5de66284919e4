// gpu_pictures.h - pictures of the gpu engine and of the cpu engine, and how much they differ.
#pragma once

#include "cpu/frame.h"
#include "gl/gl_context.h"
#include "gl/gpu_frame.h"
#include "render/check_settings.h"

#include <firsthit/firsthit.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace firsthit::test {

/// A picture of items that was made elsewhere, for views without parts.
class GivenItems : public gl::GpuItems {
  public:
    std::vector<std::uint32_t> item;

    GLuint draw(const World&, const Pencil& pencil, const Settings&, const gl::SceneBuffers&,
        Tasks&) override
    {
        texture_.resize(GL_R32UI, pencil.width, pencil.height);
        glTextureSubImage2D(texture_.name(), 0, 0, 0, pencil.width, pencil.height, GL_RED_INTEGER,
            GL_UNSIGNED_INT, item.data());
        return texture_.name();
    }

  private:
    gl::Texture2D texture_;
};

/// The cpu engine's picture, with all that it was made of.
struct CpuPicture {
    FrameMemory memory;
    Film film;
    Stats stats;

    CpuPicture(const World& world, const View& view, Settings settings)
    {
        Tasks tasks(2);
        // The gpu engine asks for the items too.
        if (settings.samples == 1 && settings.interleave == 1 &&
            std::find(settings.aovs.begin(), settings.aovs.end(), Aov::item) == settings.aovs.end())
            settings.aovs.push_back(Aov::item);
        render_frame(world, checked(view), settings, memory, tasks, film, stats);
    }
};

inline std::vector<std::uint32_t> cpu_items(const World& world, const View& view)
{
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item};
    settings.shadows = Shadows::none;
    return CpuPicture(world, view, settings).film.item;
}

/// 10 log10(1 / mean square difference) of values in [0, 1]; what is above counts as 1.
inline double psnr(const std::vector<float>& a, const std::vector<float>& b)
{
    EXPECT_EQ(a.size(), b.size());
    double sum = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        const double d = double(std::clamp(a[k], 0.0f, 1.0f)) - std::clamp(b[k], 0.0f, 1.0f);
        sum += d * d;
    }
    return sum > 0 ? 10 * std::log10(double(a.size()) / sum)
                   : std::numeric_limits<double>::infinity();
}

/// How many values differ by more than `tolerance`.
inline std::size_t count_different(
    const std::vector<float>& a, const std::vector<float>& b, float tolerance)
{
    EXPECT_EQ(a.size(), b.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
        count += !(a[k] == b[k] || std::abs(a[k] - b[k]) <= tolerance);
    return count;
}

} // namespace firsthit::test
