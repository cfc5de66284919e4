// view_scene.cpp - a scene that is looked at.
#include "view/frames/view_scene.h"

#include <system_error>

namespace firsthit::cli::view {
namespace {

std::filesystem::file_time_type time_of(const std::string& path)
{
    std::error_code none;
    return std::filesystem::last_write_time(path, none); // the least time where it is missing
}

} // namespace

ViewScene::ViewScene(const RenderOptions& given) : options_(given)
{
    read_files(options_);
    turn_suns(options_.camera.up_axis.value_or(usual_up_axis(options_.scene.shown_name())),
        options_.light);
    options_.scene.fps_of_frames = true;
    const bool has_lights = !options_.light.lights.empty();
    source_ = std::make_unique<SceneSource>(options_.scene, scene_changes(options_));
    first_ = source_->first();
    numbered_ = source_->sequence().is_numbered();
    end_s_ = source_->sequence().end_s();
    studio_ = wants_studio(options_.sky, *first_, has_lights);
    take_size(*first_, options_.camera);
    start_ = pose_settings(options_.scene.pose, *first_);
    start_.time_s = options_.frames.time_s.value_or(start_.time_s);
    for (const std::string& file : first_->files) times_[file] = {};
    note_times();

    World world;
    pose(source_->scene_at(start_.time_s), start_, world);
    views_ = std::make_unique<ViewMaker>(options_.camera, options_.scene.shown_name());
    start_camera_ = views_->view(world).camera;
    const std::array<glm::vec3, 2> box = bounds(world);
    box_ = {glm::dvec3(box[0]), glm::dvec3(box[1])};
    up_axis_ = options_.camera.up_axis.value_or(usual_up_axis(options_.scene.shown_name()));
    if (!options_.camera.up_axis && up_axis_.z > 0) up_axis_ = upward_axis(world, up_axis_);
}

std::shared_ptr<const Scene> ViewScene::scene_at(double time_s)
{
    const std::lock_guard lock(mutex_);
    return source_->scene_at(time_s);
}

View ViewScene::view(World& world, int width, int height, const Camera* camera)
{
    View view;
    if (camera) {
        view.camera = *camera;
        hang_lights(*camera, world);
    } else {
        const std::lock_guard lock(mutex_);
        view = views_->view(world);
        const bool lens = view.camera.focal || view.camera.principal_point;
        if (lens && (view.width != width || view.height != height)) {
            FileCamera file;
            file.camera = view.camera;
            file.width = view.width;
            file.height = view.height;
            view.camera = resized_camera(file, width, height);
        }
    }
    view.width = width;
    view.height = height;
    view.region = {};
    return view;
}

Settings ViewScene::settings() const
{
    Settings settings = render_settings(options_);
    apply(options_.sky, studio_, settings);
    return settings;
}

double ViewScene::begin_s(std::int32_t clip) const
{
    return numbered_ ? 0 : first_->begin_s(clip);
}

double ViewScene::end_s(std::int32_t clip) const
{
    return numbered_ ? end_s_ : first_->end_s(clip);
}

void ViewScene::note_times()
{
    for (auto& [file, time] : times_) time = time_of(file);
}

bool ViewScene::has_changed() const
{
    for (const auto& [file, time] : times_) {
        const auto now = time_of(file);
        if (now != time && now != std::filesystem::file_time_type::min()) return true;
    }
    return false;
}

} // namespace firsthit::cli::view
