// frame_maker.cpp - who makes the frames of a scene: one of our engines, or Embree.
#include "bench/baseline/frame_maker.h"

#include "bench/measure/quartiles.h"
#include "common/stopwatch.h"

#include <ctime>

namespace firsthit::cli::bench {

namespace {

std::vector<Aov> planes(bool items)
{
    return items ? std::vector<Aov>{Aov::item} : std::vector<Aov>();
}

class OurFrames : public FrameMaker {
  public:
    OurFrames(const BaselineScene& scene, const Size& size, int threads, const Settings& settings)
        : scene_(scene),
          size_(size),
          settings_(settings),
          renderer_(threads)
    {
    }

  protected:
    void make(double time_s, bool items, Film& film) override
    {
        settings_.aovs = planes(items);
        renderer_.pose(scene_.scene, time_s, world_);
        renderer_.render(world_, scene_.view(world_, size_), settings_, film);
    }
    Stages stages() const override
    {
        const Stats& s = renderer_.stats();
        return {{"pose", s.pose_ms}, {"setup", s.setup_ms}, {"raster", s.raster_ms},
            {"resolve", s.resolve_ms}, {"shadow", s.shadow_ms}, {"shade", s.shade_ms}};
    }

  private:
    const BaselineScene& scene_;
    Size size_;
    Settings settings_;
    Renderer renderer_;
    World world_;
};

class EmbreeFrames : public FrameMaker {
  public:
    EmbreeFrames(const BaselineScene& scene, const Size& size, int threads, BaselineUpdate update,
        int packet)
        : scene_(scene),
          size_(size),
          baseline_(scene.scene, update, threads, packet)
    {
        settings_.shadows = Shadows::exact;
    }

  protected:
    void make(double time_s, bool items, Film& film) override
    {
        settings_.aovs = planes(items);
        const World& world = baseline_.pose(time_s);
        if (!scene_.kept) baseline_.assume_moved();
        baseline_.render(scene_.view(world, size_), settings_, film);
    }
    Stages stages() const override
    {
        const BaselineStats& s = baseline_.stats();
        return {{"pose", s.pose_ms}, {"update", s.update_ms}, {"primary", s.primary_ms},
            {"shadow", s.shadow_ms}, {"shade", s.shade_ms}};
    }

  private:
    const BaselineScene& scene_;
    Size size_;
    Settings settings_;
    EmbreeBaseline baseline_;
};

} // namespace

double process_cpu_ms()
{
    return 1000.0 * double(std::clock()) / CLOCKS_PER_SEC;
}

void FrameMaker::frame(double time_s, bool items)
{
    make(time_s, items, film_);
}

double FrameMaker::measured_frame(double time_s, int round)
{
    const double cpu_begin = process_cpu_ms();
    const Stopwatch watch;
    make(time_s, false, film_);
    const double ms = watch.ms();
    if (round >= 0) {
        cpu_ms_.push_back(process_cpu_ms() - cpu_begin);
        stages_.push_back(stages());
    }
    return ms;
}

Stages FrameMaker::median_stages() const
{
    Stages medians;
    for (std::size_t stage = 0; !stages_.empty() && stage < stages_.front().size(); ++stage) {
        std::vector<double> ms;
        for (const Stages& round : stages_) ms.push_back(round[stage].second);
        medians.emplace_back(stages_.front()[stage].first, quartiles(std::move(ms)).median);
    }
    return medians;
}

std::unique_ptr<FrameMaker> our_frames(
    const BaselineScene& scene, const Size& size, int threads, const Settings& settings)
{
    return std::make_unique<OurFrames>(scene, size, threads, settings);
}

std::unique_ptr<FrameMaker> embree_frames(
    const BaselineScene& scene, const Size& size, int threads, BaselineUpdate update, int packet)
{
    return std::make_unique<EmbreeFrames>(scene, size, threads, update, packet);
}

double round_time(const BaselineScene& scene, int round)
{
    return scene.time_s + (round + FrameMaker::kWarmUp) * kFrameTime_s;
}

Contender contender(std::string name, const BaselineScene& scene, FrameMaker& maker)
{
    return {std::move(name), [&scene, &maker](int round) {
                return maker.measured_frame(round_time(scene, round), round);
            }};
}

} // namespace firsthit::cli::bench
