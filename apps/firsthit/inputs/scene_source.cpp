// scene_source.cpp - the scene of each time: a single file, or a sequence of them.
#include "inputs/scene_source.h"

#include "common/output.h"
#include "inputs/standard_input.h"
#include "common/usage.h"

#include <fmt/format.h>

#include <utility>

namespace firsthit::cli {
namespace {

SequenceSettings settings_of(const SceneOptions& options, std::function<void(Scene&)> change)
{
    if (options.fps && !options.fps_of_frames && !is_sequence_name(options.name))
        throw UsageError(fmt::format("--fps is of numbered files, as in frames/%04d.obj; '{}' is a "
                                     "single scene",
            options.name));
    if (options.name == "-" && options.format.empty())
        throw UsageError(
            "a scene from standard input has no ending that says what it is: say --format "
            "ply, stl, obj, off, glb, gltf, fbx, dae, 3mf, aff or nff");
    if (options.name != "-" && !options.format.empty())
        throw UsageError(fmt::format(
            "--format is of standard input, the scene -; '{}' has its ending", options.name));
    SequenceSettings settings;
    settings.load = options.load;
    settings.fps = options.fps.value_or(settings.fps);
    settings.change = std::move(change);
    return settings;
}

} // namespace

SceneSequence open_scene(const SceneOptions& options, std::function<void(Scene&)> change)
{
    SequenceSettings settings = settings_of(options, std::move(change));
    if (options.name == "-") return read_standard_input(options.format, std::move(settings));
    return SceneSequence(options.name, settings);
}

WarningPrinter::~WarningPrinter()
{
    if (texts_.size() > kinds_.size())
        print_warnings(
            {fmt::format("{} more such warnings of other frames", texts_.size() - kinds_.size())});
}

void WarningPrinter::print(const std::vector<std::string>& warnings)
{
    for (const std::string& warning : warnings) {
        std::string kind;
        for (const char c : warning)
            if (c < '0' || '9' < c) kind += c;
        texts_.insert(warning);
        if (kinds_.insert(kind).second) print_warnings({warning});
    }
}

SceneSource::SceneSource(const SceneOptions& options, std::function<void(Scene&)> change)
    : sequence_(open_scene(options, std::move(change)))
{
    warnings_.print(sequence_.warnings());
}

std::shared_ptr<const Scene> SceneSource::scene_at(double time_s)
{
    return told(sequence_.scene_at(time_s));
}

std::shared_ptr<const Scene> SceneSource::told(std::shared_ptr<const Scene> scene)
{
    if (scene != last_) {
        if (sequence_.is_numbered())
            warnings_.print(scene->warnings);
        else
            print_warnings(scene->warnings);
    }
    last_ = scene;
    return scene;
}

} // namespace firsthit::cli
