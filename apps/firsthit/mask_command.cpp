// mask_command.cpp - `firsthit mask`: masks of what is seen, for data sets.
#include "mask_command.h"

#include "common/add_parsed.h"
#include "common/interrupt.h"
#include "common/output.h"
#include "common/progress.h"
#include "common/usage.h"
#include "masks/coco_file.h"
#include "inputs/frame_pattern.h"
#include "inputs/scene_source.h"

#include <firsthit/file.h>
#include <firsthit/render.h>
#include <firsthit/world_parts.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace firsthit::cli {
namespace {

constexpr const char* kMaskExamples = R"(Examples:
  firsthit mask builtin:robots -o masks.json
  firsthit mask town.glb -o masks.json --by node --picture town.png
  firsthit mask walk.glb -o masks.json --frames clip --picture walk_%04d.png
  firsthit mask town.glb -o masks.json --camera transforms.json --picture town_%04d.png
  firsthit mask builtin:robots -o - --counts list --no-visibility

The file has the layout of the COCO data set, as pycocotools and detectron2 read it: images,
categories, and an annotation for each object that is seen, with
  segmentation  its mask: runs of pixels down the columns ("RLE"), as text or as a list
  area, bbox    its pixels, and the box [x, y, width, height] around them
  visibility    of the pixels that would see it if it was alone in the scene, the share that
                does, exactly; pixels_alone counts them. What is hidden altogether is listed
                with its image as "hidden"
Pixels are those of the planes of `firsthit render`: of the ray through each pixel's centre.
Exit codes: 0 done, 1 failed, 2 wrong usage.)";

bool parse_counts(const std::string& text)
{
    if (text == "compressed") return true;
    if (text == "list") return false;
    throw UsageError(fmt::format("'{}' is not accepted: compressed or list", text));
}

/// Whose ids these are, seen pixels and those that would be.
MaskedPicture mask_picture(
    Renderer& renderer, const World& world, const View& view, const MaskOptions& options)
{
    Settings settings;
    settings.color = false;
    settings.aovs = {options.kind};
    Film film;
    renderer.render(world, view, settings, film);
    MaskedPicture picture;
    picture.width = film.width;
    picture.height = film.height;
    picture.time_s = world.time_s;
    picture.masks = masks_of(film.ids(options.kind), std::uint32_t(film.width), kNoItem);
    if (options.visibility)
        picture.alone =
            pixels_alone(renderer, world, view, mask_objects(*world.scene, options.kind).instances);
    return picture;
}

} // namespace

void add_mask_options(CLI::App& app, MaskOptions& options)
{
    add_scene_options(app, options.scene);
    app.add_option("-o,--output", options.output, "The JSON file; - is standard output")
        ->required()
        ->type_name("FILE");
    add_parsed(app, "--by", options.kind, parse_mask_kind, "instance|node|material",
        "What gets a mask of its own; default instance");
    add_parsed(app, "--counts", options.compressed, parse_counts, "compressed|list",
        "How masks are written: as COCO's compressed text, or as lists of numbers; default "
        "compressed");
    app.add_option("--picture", options.picture,
           "The name of the picture that the file tells; with frames it has one %d, %4d or %04d; "
           "default picture.png")
        ->type_name("NAME");
    app.add_flag_callback(
        "--no-visibility", [&options] { options.visibility = false; },
        "Leave out what would be seen if objects were alone, which takes a small picture for each");
    add_picture_set_options(app, options);
    app.footer(kMaskExamples);
}

void check(const MaskOptions& options)
{
    if (options.output != "-") check_output_path(options.output);
    if (options.several() && options.picture != MaskOptions().picture)
        (void)FramePattern(options.picture);
}

int run_mask(const MaskOptions& given)
{
    MaskOptions options = given;
    read_files(options);
    check(options);
    options.scene.fps_of_frames = options.frames.clip || !options.frames.numbers.empty();
    if (options.several() && options.picture == MaskOptions().picture)
        options.picture = "picture_%04d.png";
    SceneSource source(options.scene);
    std::shared_ptr<const Scene> scene = source.first();
    take_size(*scene, options.camera);
    if (options.output != "-") check_output_replaces_nothing(options, *scene, {options.output});
    PoseSettings chosen = pose_settings(options.scene.pose, *scene);
    const Frames frames = frames_of(options, options.frames, *scene, chosen);
    Renderer renderer(options.threads);
    ViewMaker views(options.camera, options.scene.name);
    CocoFile file(std::string(aov_name(options.kind)), options.compressed);
    World world;
    {
        Progress progress("frames", frames.size());
        for (std::size_t k = 0; k < frames.size(); ++k) {
            chosen.time_s = frames.time_s[k];
            scene = source.scene_at(chosen.time_s);
            renderer.pose(scene, chosen, world);
            const View view = views.view(world, k);
            MaskedPicture picture = mask_picture(renderer, world, view, options);
            picture.file_name = options.several()
                                    ? FramePattern(options.picture).name(frames.number[k])
                                    : options.picture;
            file.add(mask_objects(*scene, options.kind), picture);
            progress.advance();
        }
    }
    const std::string text = file.text(options.scene.name);
    const HoldInterrupts hold;
    if (options.output == "-")
        print(text);
    else
        write_file(options.output, text);
    return kExitDone;
}

} // namespace firsthit::cli
