// camera_file_test.cpp - cameras of files: where they put known points, and what is refused.
#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/camera_file.h>
#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace firsthit {
namespace {

/// A rotation about an axis, by Rodrigues' formula: rows of a matrix.
std::array<glm::dvec3, 3> rotation(glm::dvec3 axis, double angle)
{
    axis /= std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
    const double c = std::cos(angle), s = std::sin(angle);
    const double x = axis.x, y = axis.y, z = axis.z;
    return {glm::dvec3(c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s),
        glm::dvec3(y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s),
        glm::dvec3(z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c))};
}

std::string json_rows(const std::array<glm::dvec3, 3>& rows)
{
    return fmt::format("[[{},{},{}],[{},{},{}],[{},{},{}]]", rows[0].x, rows[0].y, rows[0].z,
        rows[1].x, rows[1].y, rows[1].z, rows[2].x, rows[2].y, rows[2].z);
}

std::string json_matrix(const std::array<glm::dvec3, 3>& rows, const glm::dvec3& t)
{
    return fmt::format("[[{},{},{},{}],[{},{},{},{}],[{},{},{},{}],[0,0,0,1]]", rows[0].x,
        rows[0].y, rows[0].z, t.x, rows[1].x, rows[1].y, rows[1].z, t.y, rows[2].x, rows[2].y,
        rows[2].z, t.z);
}

/// Where view.h says that a camera shows a point, pixels from the top left.
glm::dvec2 place(const Camera& camera, const glm::dvec3& p)
{
    const glm::dvec3 forward = glm::normalize(camera.direction);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 down = glm::cross(forward, right), d = p - camera.eye;
    const double x = glm::dot(d, right), y = glm::dot(d, down), z = glm::dot(d, forward);
    return {camera.focal->x * x / z + camera.skew * y / z + camera.principal_point->x,
        camera.focal->y * y / z + camera.principal_point->y};
}

/// Points before a camera with world-to-camera rows R and translation t, in world space, and where the matrix
/// K [R t] puts them: OpenCV's camera.
struct KnownPoints {
    std::array<glm::dvec3, 3> r = rotation({0.3, -1, 0.2}, 2.1);
    glm::dvec3 t{0.4, -0.7, 5.5};
    double fx = 830.5, fy = 790.25, cx = 301.75, cy = 255.5, skew = 3.5;
    std::vector<glm::dvec3> world;
    std::vector<glm::dvec2> pixel; // OpenCV's: (0, 0) is the centre of the first pixel

    KnownPoints()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (int k = 0; k < 1000; ++k) {
            const glm::dvec3 c(2 * unit(random), 2 * unit(random), 6 + 3 * unit(random));
            // World = R transposed (c - t).
            const glm::dvec3 d = c - t;
            world.push_back(d.x * r[0] + d.y * r[1] + d.z * r[2]);
            pixel.emplace_back((fx * c.x + skew * c.y) / c.z + cx, fy * c.y / c.z + cy);
        }
    }

    std::string k() const
    {
        return fmt::format(R"("K":[[{},{},{}],[0,{},{}],[0,0,1]])", fx, skew, cx, fy, cy);
    }
    /// The matrix from a camera to the world, whose axes y and z go the other way if sign is -1.
    std::string to_world(double sign) const
    {
        const glm::dvec3 eye = -(t.x * r[0] + t.y * r[1] + t.z * r[2]);
        std::array<glm::dvec3, 3> rows;
        for (int c = 0; c < 3; ++c)
            rows[std::size_t(c)] = {r[0][c], sign * r[1][c], sign * r[2][c]};
        return json_matrix(rows, eye);
    }
};

void expect_places(const KnownPoints& known, const Camera& camera, double shift)
{
    for (std::size_t k = 0; k < known.world.size(); ++k) {
        const glm::dvec2 at = place(camera, known.world[k]);
        ASSERT_NEAR(at.x, known.pixel[k].x + shift, 1e-8);
        ASSERT_NEAR(at.y, known.pixel[k].y + shift, 1e-8);
    }
}

class CameraFile : public testing::Test {
  protected:
    std::vector<FileCamera> read(const std::string& json, const char* name = "c.json")
    {
        return read_cameras(folder_.write(name, json).string());
    }
    /// The message without the folder.
    std::string refusal(const std::string& json, const char* name = "c.json")
    {
        std::string text = message_of<FileError>([&] { read(json, name); });
        const std::string path = folder_ / "";
        for (std::size_t at; (at = text.find(path)) != std::string::npos;)
            text.erase(at, path.size());
        return text;
    }

    TemporaryFolder folder_;
};

TEST_F(CameraFile, KWithAPoseInAnyFormShowsPointsWhereOpenCvDoes)
{
    const KnownPoints known;
    const std::string head = R"({"width":640,"height":480,)" + known.k() + ",";
    const std::string poses[] = {
        R"("convention":"opencv","R":)" + json_rows(known.r) +
            fmt::format(R"(,"t":[{},{},{}])", known.t.x, known.t.y, known.t.z),
        R"("convention":"opencv","world_to_camera":)" + json_matrix(known.r, known.t),
        R"("convention":"opencv","camera_to_world":)" + known.to_world(1),
        R"("convention":"opengl","pixel_center":0,"camera_to_world":)" + known.to_world(-1),
        R"("convention":"blender","pixel_center":0,"camera_to_world":)" + known.to_world(-1)};
    for (const std::string& pose : poses) {
        const std::vector<FileCamera> cameras = read(head + pose + "}");
        ASSERT_EQ(cameras.size(), 1u);
        EXPECT_EQ(cameras[0].width, 640);
        EXPECT_EQ(cameras[0].height, 480);
        expect_places(known, cameras[0].camera, 0.5);
    }
    // Blender's and OpenGL's pixels have their centres at halves, unless something else is said.
    const std::string gl =
        head + R"("convention":"opengl","camera_to_world":)" + known.to_world(-1) + "}";
    expect_places(known, read(gl)[0].camera, 0);
    expect_places(known, read_cameras(folder_ / "c.json", 0.0)[0].camera, 0.5);
    EXPECT_THROW(read_cameras(folder_ / "c.json", 0.25), ArgumentError);
}

TEST_F(CameraFile, ScalesTheLensWithThePicture)
{
    const KnownPoints known;
    const FileCamera camera = read(R"({"width":640,"height":480,)" + known.k() +
                                   R"(,"convention":"opencv","world_to_camera":)" +
                                   json_matrix(known.r, known.t) + "}")[0];
    const Camera half = resized_camera(camera, 320, 120);
    for (std::size_t k = 0; k < 100; ++k) {
        const glm::dvec2 at = place(half, known.world[k]);
        EXPECT_NEAR(at.x, 0.5 * (known.pixel[k].x + 0.5), 1e-8);
        EXPECT_NEAR(at.y, 0.25 * (known.pixel[k].y + 0.5), 1e-8);
    }
}

TEST_F(CameraFile, TransformsOfNerfLookAlongMinusZ)
{
    const KnownPoints known;
    const std::string frames = R"("frames":[{"file_path":"a.png","transform_matrix":)" +
                               known.to_world(-1) + R"(},{"file_path":"b","transform_matrix":)" +
                               json_matrix(rotation({0, 0, 1}, 0), {1, 2, 3}) + "}]}";
    const std::vector<FileCamera> cameras =
        read(fmt::format(R"({{"w":640,"h":480,"fl_x":{},"fl_y":{},"cx":{},"cy":{},"k1":0,)",
                 known.fx, known.fy, known.cx, known.cy) +
             frames);
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0].name, "a.png");
    EXPECT_EQ(cameras[1].camera.eye, glm::dvec3(1, 2, 3));
    EXPECT_EQ(cameras[1].camera.direction, glm::dvec3(0, 0, -1));
    EXPECT_EQ(cameras[1].camera.up, glm::dvec3(0, 1, 0));
    KnownPoints straight;
    straight.skew = 0;
    for (std::size_t k = 0; k < known.world.size(); ++k) {
        const glm::dvec3 d = known.world[k];
        const glm::dvec3 c(glm::dot(known.r[0], d) + known.t.x, glm::dot(known.r[1], d) + known.t.y,
            glm::dot(known.r[2], d) + known.t.z);
        const glm::dvec2 at = place(cameras[0].camera, d);
        ASSERT_NEAR(at.x, known.fx * c.x / c.z + known.cx, 1e-8);
        ASSERT_NEAR(at.y, known.fy * c.y / c.z + known.cy, 1e-8);
    }
    // By its angle alone the lens follows from the picture's width.
    const FileCamera angle = read(R"({"camera_angle_x":0.6911112,)" + frames)[0];
    EXPECT_EQ(angle.width, 0);
    const Camera shown = resized_camera(angle, 800, 600);
    EXPECT_NEAR(shown.focal->x, 400 / std::tan(0.6911112 / 2), 1e-9);
    EXPECT_EQ(shown.focal->x, shown.focal->y);
}

TEST_F(CameraFile, ColmapsQuaternionsAreFromTheWorldToTheCamera)
{
    const KnownPoints known;
    // The quaternion of rotation({0.3, -1, 0.2}, 2.1), by half the angle.
    glm::dvec3 axis(0.3, -1, 0.2);
    axis *= std::sin(1.05) / std::sqrt(0.09 + 1 + 0.04);
    folder_.write("colmap/cameras.txt",
        fmt::format("# comment\n3 PINHOLE 640 480 {} {} {} {}\n7 SIMPLE_RADIAL 10 20 30 5 10 0\n",
            known.fx, known.fy, known.cx, known.cy));
    folder_.write("colmap/images.txt",
        fmt::format("# comment\n1 {} {} {} {} {} {} {} 3 a b.jpg\n1 2 -1 3 4 5\n2 1 0 0 0 0 0 0 7 "
                    "c.jpg\n\n",
            std::cos(1.05), axis.x, axis.y, axis.z, known.t.x, known.t.y, known.t.z));
    for (const char* name : {"colmap", "colmap/cameras.txt", "colmap/images.txt"}) {
        const std::vector<FileCamera> cameras = read_cameras(folder_ / name);
        ASSERT_EQ(cameras.size(), 2u);
        EXPECT_EQ(cameras[0].name, "a b.jpg");
        EXPECT_EQ(cameras[1].width, 10);
        EXPECT_EQ(cameras[1].camera.direction, glm::dvec3(0, 0, 1));
        EXPECT_EQ(cameras[1].camera.up, glm::dvec3(0, -1, 0));
        for (std::size_t k = 0; k < known.world.size(); ++k) {
            const glm::dvec3 d = known.world[k];
            const glm::dvec3 c(glm::dot(known.r[0], d) + known.t.x,
                glm::dot(known.r[1], d) + known.t.y, glm::dot(known.r[2], d) + known.t.z);
            const glm::dvec2 at = place(cameras[0].camera, d);
            ASSERT_NEAR(at.x, known.fx * c.x / c.z + known.cx, 1e-8);
            ASSERT_NEAR(at.y, known.fy * c.y / c.z + known.cy, 1e-8);
        }
    }
}

TEST_F(CameraFile, WhatIsNoCameraIsRefusedWithItsPlace)
{
    const std::string k = R"("K":[[9,0,4],[0,9,4],[0,0,1]])";
    const std::string head = R"({"width":8,"height":8,)" + k + R"(,"convention":"opencv",)";
    const std::string eye = R"("R":[[1,0,0],[0,1,0],[0,0,1]],"t":[0,0,0])";
    EXPECT_EQ(refusal(head + R"("R":[[1,0,0],[0,1,0],[0,0,-1]],"t":[0,0,0]})"),
        "c.json: R: left-handed: its determinant is -1, that of a mirror; accepted is 1");
    EXPECT_EQ(refusal(head + R"("R":[[2,0,0],[0,1,0],[0,0,1]],"t":[0,0,0]})"),
        "c.json: R: no rotation: its rows are unit and perpendicular only to 1; accepted is 0.001, "
        "without "
        "scale or shear");
    EXPECT_EQ(refusal(head + R"("R":[[1,0,0],[0,1,0]],"t":[0,0,0]})"),
        "c.json: R: accepted are 3 rows of 3 numbers");
    EXPECT_EQ(refusal(head + R"("camera_to_world":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]]})"),
        "c.json: camera_to_world: its last row is 0, 0, 1, 1; accepted is 0, 0, 0, 1");
    EXPECT_EQ(refusal(head + eye + R"(,"distortion":[0,0.1]})"),
        "c.json: distortion: a coefficient of distortion is 0.1: accepted is 0; lenses that bend "
        "lines are "
        "not drawn: undistort the pictures and take the camera of those");
    EXPECT_EQ(refusal(R"({"width":0,"height":8,)" + k + R"(,"convention":"opencv",)" + eye + "}"),
        "c.json: width: 0 is no whole number from 1 to 65536");
    EXPECT_EQ(refusal(R"({"width":8,"height":8,)" + k + "," + eye + "}"),
        "c.json: convention: is missing: accepted are opencv (x right, y down, z forward), opengl "
        "and "
        "blender (x right, y up, z backward)");
    EXPECT_EQ(refusal(R"({"width":8,"height":8,)" + k + R"(,"convention":"maya",)" + eye + "}"),
        "c.json: convention: 'maya' is no convention: accepted are opencv (x right, y down, z "
        "forward), "
        "opengl and blender (x right, y up, z backward)");
    EXPECT_EQ(refusal("[" + head + eye + "},3]"), "c.json: [1]: no object {...}");
    EXPECT_EQ(refusal(R"({"keys":[]})"), "c.json: a path of a camera, which --camera-path takes");
    EXPECT_NE(refusal("{").find("c.json: not a camera file: "), std::string::npos);
    EXPECT_NE(refusal("").find("c.json: not a camera file: "), std::string::npos);
    for (const std::string& text :
        {std::string("{}"), std::string("[]"), std::string("7"), std::string("null"),
            head + "\"t\":[0,0,0]}", head + eye + R"(,"world_to_camera":1})",
            head + R"("R":[[1,0,0],[0,1,0],[0,0,1]],"t":[0,0]})",
            head + R"("R":[[1,0,0],[0,1,0],[0,0,null]],"t":[0,0,0]})",
            head + R"("R":[[NaN,0,0],[0,1,0],[0,0,1]],"t":[0,0,0]})",
            head + R"("R":[[1e999,0,0],[0,1,0],[0,0,1]],"t":[0,0,0]})",
            head + eye + R"(,"pixel_center":0.3})", head + eye + R"(,"distortion":"none"})",
            R"({"width":8,"height":8,"K":[[0,0,4],[0,9,4],[0,0,1]],"convention":"opencv",)" + eye +
                "}",
            R"({"width":8,"height":8,"K":[[9,0,1e9],[0,9,4],[0,0,1]],"convention":"opencv",)" +
                eye + "}",
            R"({"width":8,"height":8,"K":[[9,0,4],[1,9,4],[0,0,1]],"convention":"opencv",)" + eye +
                "}",
            std::string(100000, '['), std::string(R"({"frames":[]})"),
            std::string(
                R"({"frames":[{"transform_matrix":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]})"),
            std::string(
                R"({"camera_angle_x":4,"frames":[{"transform_matrix":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]})"),
            std::string(
                R"({"camera_angle_x":1,"k1":0.1,"frames":[{"transform_matrix":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]})"),
            std::string(
                R"({"camera_angle_x":1,"w":4,"frames":[{"transform_matrix":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]})")})
        EXPECT_EQ(refusal(text).find("c.json: "), 0u) << text.substr(0, 200);
    EXPECT_THROW(read_cameras(folder_ / "none.json"), FileError);
}

TEST_F(CameraFile, ColmapsFilesAreRefusedWithTheirLine)
{
    const auto refused = [&](const std::string& cameras, const std::string& images) {
        folder_.write("c/cameras.txt", cameras);
        folder_.write("c/images.txt", images);
        std::string text = message_of<FileError>([&] { read_cameras(folder_ / "c"); });
        const std::string path = folder_ / "c/";
        for (std::size_t at; (at = text.find(path)) != std::string::npos;)
            text.erase(at, path.size());
        return text;
    };
    const std::string camera = "1 PINHOLE 8 8 9 9 4 4\n", image = "1 1 0 0 0 0 0 0 1 a.png\n\n";
    EXPECT_EQ(refused("1 OPENCV_FISHEYE 8 8 9 9 4 4 0 0 0 0\n", image),
        "cameras.txt:1: the camera model 'OPENCV_FISHEYE' is not known: accepted are "
        "SIMPLE_PINHOLE, "
        "PINHOLE, and, without distortion, SIMPLE_RADIAL, RADIAL, OPENCV and FULL_OPENCV");
    EXPECT_EQ(refused("#\n1 SIMPLE_RADIAL 8 8 9 4 4 0.01\n", image)
                  .find("cameras.txt:2: a coefficient of"),
        0u);
    EXPECT_EQ(
        refused(camera, "1 1 0 0 0 0 0 0 2 a.png\n\n").find("images.txt:1: there is no camera 2"),
        0u);
    EXPECT_EQ(refused(camera, "1 1 1 0 0 0 0 0 1 a.png\n\n"),
        "images.txt:1: the quaternion's length is 1.41421: accepted is 1");
    EXPECT_EQ(refused(camera, "1 nan 1 0 0 0 0 0 1 a.png\n\n"),
        "images.txt:1: the quaternion: 'nan' is no finite number");
    EXPECT_EQ(refused(camera, "# nothing\n"), "images.txt: no picture");
    for (const char* text : {"1 PINHOLE 0 8 9 9 4 4\n", "1 PINHOLE 8 8 9 9 4\n",
             "1 PINHOLE 8 8 0 9 4 4\n", "1 PINHOLE 8 8 9 9 4 4 4\n", "x PINHOLE 8 8 9 9 4 4\n",
             "1 PINHOLE 8 8 9 9 4 4\n1 PINHOLE 8 8 9 9 4 4\n"})
        EXPECT_EQ(refused(text, image).find("cameras.txt:"), 0u) << text;
    std::filesystem::remove(folder_.path() / "c/cameras.txt");
    EXPECT_NE(
        message_of<FileError>([&] { read_cameras(folder_ / "c"); }).find("there is no cameras.txt"),
        std::string::npos);
    folder_.write("c/cameras.bin", "x");
    EXPECT_NE(message_of<FileError>([&] { read_cameras(folder_ / "c"); }).find("model_converter"),
        std::string::npos);
}

} // namespace
} // namespace firsthit
