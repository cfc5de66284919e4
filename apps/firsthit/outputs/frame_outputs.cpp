// frame_outputs.cpp - where the frames of `firsthit render` go: files for each, or a film.
#include "outputs/frame_outputs.h"

#include "common/output.h"
#include "common/verbosity.h"

#include <firsthit/film_data.h>
#include <firsthit/picture.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace firsthit::cli {

FrameOutputs::FrameOutputs(const RenderOptions& options, const Frames& frames)
    : options_(options),
      frames_(frames)
{
    if (is_film(options)) hold_.emplace();
}

bool FrameOutputs::are_there(std::size_t frame) const
{
    const std::vector<std::string> names = outputs(options_);
    return !names.empty() && std::all_of(names.begin(), names.end(), [&](const std::string& name) {
        std::error_code ignored;
        return std::filesystem::is_regular_file(
            file_name(options_, name, frames_.number[frame]), ignored);
    });
}

std::vector<bool> FrameOutputs::to_make() const
{
    std::vector<bool> wanted = frames_in_part(options_.data.part, frames_.number);
    if (!options_.data.resume) return wanted;
    for (std::size_t frame = 0; frame < wanted.size(); ++frame)
        if (wanted[frame] && are_there(frame)) wanted[frame] = false;
    return wanted;
}

FrameOutputs::~FrameOutputs()
{
    if (written_.valid()) written_.wait();
}

void FrameOutputs::write(Film& film, std::size_t frame)
{
    wait();
    if (!hold_) hold_.emplace();
    if (frames_.size() == 1) {
        write_now(film, frame);
        wait();
        return;
    }
    std::swap(film, writing_);
    written_ = std::async(std::launch::async, [this, frame] { write_now(writing_, frame); });
}

/// Until the frame that was given last is written. Then a signal may end the program, unless a film is made.
void FrameOutputs::wait()
{
    if (written_.valid()) written_.get();
    if (!is_film(options_)) hold_.reset();
}

void FrameOutputs::write_now(const Film& film, std::size_t frame)
{
    const int number = frames_.number[frame];
    const auto name_of = [&](const std::string& text) {
        std::string name = file_name(options_, text, number);
        print_detail(fmt::format("writes {}", name));
        return name;
    };
    if (is_film(options_))
        add_to_film(film);
    else if (!options_.output.empty())
        write_picture(film, name_of(options_.output), how_to_write());
    std::vector<std::string> warnings;
    for (const AovOutput& aov : options_.aovs) {
        const std::string name = name_of(aov.path);
        const std::uint64_t far =
            write_plane(film, aov.aov, name, plane_format(options_.picture, aov.path));
        if (far > 0)
            warnings.push_back(
                fmt::format("{}: {} pixels are farther than 65.535 units, the most that "
                            "16 bits of thousandths say, and have 65535: .exr and .npy "
                            "have no such limit",
                    name, far));
    }
    print_warnings(warnings);
    const DataOptions& data = options_.data;
    if (!data.exr.empty() && data.planes)
        write_planes(film, data.planes->color, data.planes->aovs, name_of(data.exr));
}

PictureOptions FrameOutputs::how_to_write() const
{
    PictureOptions how =
        picture_options(options_.picture, options_.environment.tone, options_.output);
    how.origin = {options_.camera.region.x, options_.camera.region.y};
    return how;
}

void FrameOutputs::finish()
{
    wait();
    if (!film_) return;
    film_->finish();
    film_.reset();
    hold_.reset();
}

void FrameOutputs::add_to_film(const Film& film)
{
    if (!film_) film_.emplace(options_.output, FilmSize{film.width, film.height, frames_.fps});
    film_->add(srgb_pixels(film, options_.environment.tone, options_.picture.dither));
}

} // namespace firsthit::cli
