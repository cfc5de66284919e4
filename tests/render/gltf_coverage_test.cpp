// gltf_coverage_test.cpp - which pixels glTF models cover, against pictures that other renderers made.
#include "io/whole_file.h"
#include "readers/image/image_file.h"
#include "readers/image/webp.h"
#include "test_data.h"

#include <firsthit/render.h>
#include <firsthit/scene.h>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace firsthit {
namespace {

namespace fs = std::filesystem;

/// A line of cameras.tsv.
struct Scenario {
    std::string name, model;
    int width = 0, height = 0;
    glm::dvec3 target{0};
    double theta_deg = 0, phi_deg = 0, radius = 0, fov_deg = 0;

    View view() const
    {
        const double theta = glm::radians(theta_deg), phi = glm::radians(phi_deg);
        const glm::dvec3 away(
            std::sin(phi) * std::sin(theta), std::cos(phi), std::sin(phi) * std::cos(theta));
        View made;
        made.camera = {.eye = target + radius * away,
            .direction = -away,
            .up = {0, 1, 0},
            .fov_y_rad = glm::radians(fov_deg)};
        made.width = width;
        made.height = height;
        return made;
    }
};

std::vector<Scenario> scenarios(const fs::path& table)
{
    std::vector<Scenario> list;
    std::ifstream file(table);
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        Scenario s;
        words >> s.name >> s.model >> s.width >> s.height >> s.target.x >> s.target.y >>
            s.target.z >> s.theta_deg >> s.phi_deg >> s.radius >> s.fov_deg;
        list.push_back(s);
    }
    return list;
}

/// The fewest differing pixels of any renderer from a plain point-sampled coverage, by scenario.
std::map<std::string, long> nearest_renderers(const fs::path& table)
{
    std::map<std::string, long> nearest;
    std::ifstream file(table);
    for (std::string line; std::getline(file, line);) {
        long fewest = std::numeric_limits<long>::max();
        for (std::size_t at = line.find('('); at != std::string::npos; at = line.find('(', at + 1))
            fewest = std::min(fewest, std::strtol(line.c_str() + at + 1, nullptr, 10));
        nearest[line.substr(0, line.find(' '))] = fewest;
    }
    return nearest;
}

/// The model's file, or another form of the model that lies beside it.
fs::path model_file(const fs::path& corpus, const std::string& model)
{
    const fs::path path = corpus / model;
    if (fs::exists(path)) return path;
    for (const fs::directory_entry& entry :
        fs::recursive_directory_iterator(path.parent_path().parent_path()))
        if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
            return entry.path();
    return path;
}

long differing(const std::vector<std::uint32_t>& item, const Picture& picture)
{
    long count = 0;
    for (std::size_t k = 0; k < item.size(); ++k)
        count += (item[k] != kNoItem) != (picture.pixel[k] >> 24 >= 128);
    return count;
}

TEST(GltfCoverage, IsAsNearToOtherRenderersAsTheyAreToEachOther)
{
    const std::optional<fs::path> corpus = test_data("corpus/gltf");
    if (!corpus) GTEST_SKIP() << "no pictures: set FIRSTHIT_TEST_DATA";
    if (!can_decode_webp()) GTEST_SKIP() << "built without libwebp";
    const fs::path fidelity = *corpus / "render-fidelity";
    const std::map<std::string, long> nearest =
        nearest_renderers(fidelity / "coverage_baseline.txt");
    Renderer renderer;
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item};
    int compared = 0;
    for (const Scenario& scenario : scenarios(fidelity / "cameras.tsv")) {
        if (!nearest.contains(scenario.name)) continue;
        SCOPED_TRACE(scenario.name);
        std::vector<Picture> pictures;
        for (const fs::directory_entry& entry :
            fs::directory_iterator(fidelity / "goldens" / scenario.name))
            pictures.push_back(
                decode_picture(entry.path().string(), read_whole_file(entry.path())));
        const auto scene =
            std::make_shared<const Scene>(load_scene(model_file(*corpus, scenario.model).string()));
        long fewest = std::numeric_limits<long>::max();
        // Some renderers show the first clip's begin, others the scene at rest.
        for (const std::int32_t clip : {0, PoseSettings::kRest}) {
            World world;
            Film film;
            renderer.pose(scene, PoseSettings{.time_s = scene->begin_s(), .clip = clip}, world);
            for (const Picture& picture : pictures) {
                View view = scenario.view(); // at the picture's size
                view.width = picture.width;
                view.height = picture.height;
                renderer.render(world, view, settings, film);
                fewest = std::min(fewest, differing(film.item, picture));
            }
        }
        EXPECT_LE(double(fewest), 1.5 * double(nearest.at(scenario.name)) + 10)
            << "the nearest renderer differs in " << nearest.at(scenario.name) << " pixels";
        ++compared;
    }
    RecordProperty("scenarios", compared);
    EXPECT_GE(compared, 30);
}

} // namespace
} // namespace firsthit
