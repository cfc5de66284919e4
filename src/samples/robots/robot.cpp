// robot.cpp - one robot: its body, hung on its joints.
//
// Frames: x to the robot's left, y up, z forward; each limb hangs down from its joint.
#include "samples/robots/robot.h"

#include "samples/robots/axes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <numbers>

namespace firsthit {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

/// A tube from the joint down: a shell with a groove around its middle and rounded ends.
void add_limb(Shape& shape, double top, double bottom, double radius, double end_radius)
{
    const double middle = (top + bottom) / 2;
    const double middle_radius = (radius + end_radius) / 2;
    const auto outline = std::to_array<Outline>({
        {0, top},
        {0.55 * radius, top - 0.003},
        {0.90 * radius, top - 0.018},
        {radius, top - 0.045},
        {middle_radius * 1.02, middle + 0.016},
        {middle_radius * 0.90, middle + 0.008},
        {middle_radius * 0.90, middle - 0.008},
        {middle_radius * 1.02, middle - 0.016},
        {end_radius, bottom + 0.035},
        {0.88 * end_radius, bottom + 0.012},
        {0.50 * end_radius, bottom + 0.002},
        {0, bottom},
    });
    add_lathe(shape, outline, 10);
}

/// A short drum along x, the outside of a joint.
void add_drum(Shape& shape, const glm::dvec3& at, double radius, double half_width)
{
    const auto outline = std::to_array<Outline>({
        {0, half_width},
        {0.80 * radius, half_width},
        {radius, half_width * 0.7},
        {radius, -half_width * 0.7},
        {0.80 * radius, -half_width},
        {0, -half_width},
    });
    add_lathe(shape, outline, 12, moved(at.x, at.y, at.z, kZ, kQuarter));
}

class RobotMaker {
  public:
    RobotMaker(RobotScene& scene, std::string name, const RobotPaint& paint)
        : scene_(scene),
          name_(std::move(name)),
          paint_(paint)
    {
    }

    std::int32_t node(const char* part, std::int32_t parent, Track track)
    {
        return scene_.add_node(name_ + " " + part, parent, std::move(track));
    }

    void add_hips(std::int32_t hips)
    {
        Shape shell;
        add_rounded_box(shell, {0.15, 0.085, 0.115}, 0.06, 3, moved(0, 0.015, 0), 0.7);
        scene_.add_shape(hips, paint_.body, std::move(shell));

        // Bellows up to the torso, the axle of the legs.
        Shape metal;
        std::vector<Outline> bellows;
        for (int k = 0; k <= 8; ++k)
            bellows.push_back({k % 2 == 0 ? 0.085 : 0.105, 0.18 - 0.015 * k});
        add_lathe(metal, bellows, 12);
        for (const double side : {-1.0, 1.0}) add_drum(metal, {side * 0.155, 0, 0}, 0.075, 0.035);
        scene_.add_shape(hips, paint_.rubber, std::move(metal));
    }

    void add_torso(std::int32_t torso)
    {
        Shape shell;
        add_rounded_box(shell, {0.255, 0.235, 0.165}, 0.085, 4, moved(0, 0.30, 0), 0.66);
        scene_.add_shape(torso, paint_.body, std::move(shell));

        Shape plate;
        add_rounded_box(
            plate, {0.155, 0.115, 0.04}, 0.035, 2, moved(0, 0.365, 0.145, kX, -0.05), 0.8);
        add_rounded_box(plate, {0.15, 0.15, 0.07}, 0.045, 2, moved(0, 0.32, -0.165), 0.85); // pack
        for (const double side : {-1.0, 1.0})
            add_lathe(plate,
                std::to_array<Outline>({{0, 0.12}, {0.030, 0.117}, {0.042, 0.10}, {0.042, -0.08},
                    {0.03, -0.10}, {0.022, -0.12}, {0, -0.12}}),
                9, moved(side * 0.075, 0.30, -0.235));
        scene_.add_shape(torso, paint_.metal, std::move(plate));

        Shape lamp;
        add_ellipsoid(lamp, {0.048, 0.048, 0.022}, 14, moved(0, 0.39, 0.183));
        for (int k = -1; k <= 1; ++k)
            add_ellipsoid(lamp, {0.013, 0.013, 0.01}, 6, moved(0.05 * k, 0.31, 0.181));
        scene_.add_shape(torso, paint_.glow, std::move(lamp));

        Shape joints;
        add_lathe(joints,
            std::to_array<Outline>({{0.07, 0.64}, {0.07, 0.62}, {0.079, 0.605}, {0.072, 0.59},
                {0.082, 0.575}, {0.075, 0.56}, {0.098, 0.545}, {0.10, 0.52}}),
            12);
        for (const double side : {-1.0, 1.0})
            add_ellipsoid(joints, {0.09, 0.09, 0.09}, 10, moved(side * 0.285, 0.44, 0));
        scene_.add_shape(torso, paint_.rubber, std::move(joints));
    }

    void add_head(std::int32_t head)
    {
        Shape shell;
        add_rounded_box(shell, {0.15, 0.125, 0.135}, 0.085, 4, moved(0, 0.17, 0.01), 0.86);
        add_lathe(shell,
            std::to_array<Outline>({{0, 0.315}, {0.03, 0.314}, {0.05, 0.305}, {0.055, 0.285}}), 14);
        scene_.add_shape(head, paint_.body, std::move(shell));

        Shape dark;
        add_rounded_box(dark, {0.12, 0.055, 0.03}, 0.03, 2, moved(0, 0.19, 0.128));
        for (const double side : {-1.0, 1.0}) add_drum(dark, {side * 0.148, 0.17, 0}, 0.055, 0.028);
        // Mouth: three bars.
        for (int k = -1; k <= 1; ++k)
            add_rounded_box(
                dark, {0.045, 0.006, 0.01}, 0.005, 1, moved(0, 0.085 + 0.018 * k, 0.130));
        scene_.add_shape(head, paint_.rubber, std::move(dark));

        Shape antennae;
        for (const double side : {-1.0, 1.0})
            add_lathe(antennae,
                std::to_array<Outline>(
                    {{0.004, 0.17}, {0.005, 0.04}, {0.011, 0.025}, {0.02, 0.0}, {0.026, -0.02}}),
                7, moved(side * 0.10, 0.285, -0.03, kZ, -side * 0.32));
        scene_.add_shape(head, paint_.metal, std::move(antennae));

        Shape lights;
        for (const double side : {-1.0, 1.0}) {
            add_ellipsoid(lights, {0.032, 0.032, 0.018}, 12, moved(side * 0.052, 0.193, 0.155));
            const glm::dmat4 tip = moved(side * 0.10, 0.285, -0.03, kZ, -side * 0.32);
            add_ellipsoid(lights, {0.019, 0.019, 0.019}, 8, tip * moved(0, 0.18, 0));
        }
        scene_.add_shape(head, paint_.glow, std::move(lights));
    }

    void add_arm(std::int32_t upper, std::int32_t fore, const RobotSize& robot)
    {
        Shape sleeve;
        add_limb(sleeve, 0.0, -robot.upper_arm + 0.035, 0.068, 0.05);
        // Shoulder cap.
        add_ellipsoid(sleeve, {0.092, 0.088, 0.098}, 12, moved(0, 0.03, 0));
        scene_.add_shape(upper, paint_.body, std::move(sleeve));
        Shape elbow;
        add_drum(elbow, {0, -robot.upper_arm, 0}, 0.048, 0.052);
        scene_.add_shape(upper, paint_.rubber, std::move(elbow));

        Shape shell;
        add_limb(shell, -0.035, -0.275, 0.05, 0.06);
        scene_.add_shape(fore, paint_.metal, std::move(shell));
        Shape hand;
        add_ellipsoid(hand, {0.035, 0.035, 0.035}, 6, moved(0, -0.285, 0));
        add_rounded_box(hand, {0.022, 0.042, 0.04}, 0.018, 2, moved(0, -0.33, 0));
        for (int finger = -1; finger <= 1; ++finger)
            add_rounded_box(hand, {0.0105, 0.036, 0.0105}, 0.009, 1,
                moved(0, -0.395, 0.026 * finger, kX, -0.12 * finger));
        add_rounded_box(
            hand, {0.0105, 0.03, 0.0105}, 0.009, 1, moved(0, -0.335, 0.062, kX, -0.6)); // thumb
        scene_.add_shape(fore, paint_.rubber, std::move(hand));
    }

    void add_leg(std::int32_t thigh, std::int32_t shin, std::int32_t foot, const RobotSize& robot)
    {
        Shape shell;
        add_limb(shell, 0.02, -robot.thigh + 0.03, 0.088, 0.066);
        scene_.add_shape(thigh, paint_.body, std::move(shell));
        Shape knee;
        add_drum(knee, {0, -robot.thigh, 0}, 0.062, 0.07);
        scene_.add_shape(thigh, paint_.rubber, std::move(knee));

        Shape calf;
        add_limb(calf, -0.025, -robot.shin + 0.03, 0.06, 0.07);
        add_rounded_box(calf, {0.045, 0.13, 0.025}, 0.022, 2, moved(0, -0.2, 0.05), 0.8);
        scene_.add_shape(shin, paint_.metal, std::move(calf));
        Shape cap;
        add_ellipsoid(cap, {0.05, 0.06, 0.035}, 10, moved(0, 0.0, 0.055));
        scene_.add_shape(shin, paint_.body, std::move(cap));

        Shape ankle;
        add_drum(ankle, {0, 0, 0}, 0.045, 0.055);
        add_rounded_box(
            ankle, {0.075, 0.016, 0.145}, 0.012, 1, moved(0, -robot.ankle + 0.016, 0.045)); // sole
        scene_.add_shape(foot, paint_.rubber, std::move(ankle));
        Shape shoe;
        add_rounded_box(shoe, {0.068, 0.05, 0.13}, 0.045, 3, moved(0, -0.035, 0.05));
        scene_.add_shape(foot, paint_.body, std::move(shoe));
    }

  private:
    RobotScene& scene_;
    std::string name_;
    RobotPaint paint_;
};

} // namespace

void add_robot(RobotScene& scene, const std::string& name, const RobotPaint& paint,
    const Walk& walk, double begin_s, double end_s)
{
    const RobotSize robot;
    WalkTracks tracks = make_walk(name, walk, robot, begin_s, end_s);
    RobotMaker maker(scene, name, paint);

    const std::int32_t root = maker.node("way", -1, std::move(tracks.root));
    const std::int32_t size =
        scene.add_node(name + " size", root, glm::scale(glm::dmat4(1), glm::dvec3(walk.size)));
    const std::int32_t hips = maker.node("hips", size, std::move(tracks.hips));
    const std::int32_t torso = maker.node("torso", hips, std::move(tracks.torso));
    const std::int32_t head = maker.node("head", torso, std::move(tracks.head));
    maker.add_hips(hips);
    maker.add_torso(torso);
    maker.add_head(head);
    for (std::size_t side = 0; side < 2; ++side) {
        const std::int32_t upper =
            maker.node("upper arm", torso, std::move(tracks.upper_arm[side]));
        const std::int32_t fore = maker.node("forearm", upper, std::move(tracks.forearm[side]));
        maker.add_arm(upper, fore, robot);
        const std::int32_t thigh = maker.node("thigh", hips, std::move(tracks.thigh[side]));
        const std::int32_t shin = maker.node("shin", thigh, std::move(tracks.shin[side]));
        const std::int32_t foot = maker.node("foot", shin, std::move(tracks.foot[side]));
        maker.add_leg(thigh, shin, foot, robot);
    }
}

} // namespace firsthit
