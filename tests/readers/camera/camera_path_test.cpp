// camera_path_test.cpp - a camera that moves through keys.
#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/camera_file.h>
#include <firsthit/error.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

CameraPath path_of(const std::string& json)
{
    const TemporaryFolder folder;
    return read_camera_path(folder.write("p.json", json).string());
}

std::string path_refusal(const std::string& json)
{
    const TemporaryFolder folder;
    const std::string name = folder.write("p.json", json).string();
    std::string text = message_of<FileError>([&] { read_camera_path(name); });
    if (text.starts_with(name)) text.erase(0, name.size());
    return text;
}

constexpr const char* kThree = R"({"fps":10,"keys":[
    {"time":1,"eye":[0,0,5],"target":[0,0,0],"fov":60},
    {"time":2,"eye":[2,0,5],"target":[0,1,0],"fov":40},
    {"time":4,"eye":[2,4,5],"target":[0,1,0],"up":[0,1,1],"fov":40}]})";

TEST(CameraPath, GoesStraightFromKeyToKey)
{
    const CameraPath path = path_of(kThree);
    EXPECT_EQ(path.fps, 10);
    const Camera before = camera_at(path, -3), middle = camera_at(path, 1.5),
                 late = camera_at(path, 3), after = camera_at(path, 9);
    EXPECT_EQ(before.eye, glm::dvec3(0, 0, 5));
    EXPECT_NEAR(before.fov_y_rad, std::numbers::pi / 3, 1e-12);
    EXPECT_EQ(middle.eye, glm::dvec3(1, 0, 5));
    EXPECT_EQ(middle.direction, glm::dvec3(-1, 0.5, -5));
    EXPECT_NEAR(middle.fov_y_rad, 50 * std::numbers::pi / 180, 1e-12);
    EXPECT_EQ(late.eye, glm::dvec3(2, 2, 5));
    EXPECT_EQ(late.up, glm::dvec3(0, 1, 0.5));
    EXPECT_EQ(after.eye, glm::dvec3(2, 4, 5));
}

TEST(CameraPath, ASmoothOneGoesThroughTheKeysWithoutABend)
{
    std::string text = kThree;
    text.replace(text.find("\"fps\""), 5, "\"interpolation\":\"smooth\",\"fps\"");
    const CameraPath path = path_of(text);
    for (const CameraKey& key : path.keys) {
        EXPECT_LT(glm::length(camera_at(path, key.time_s).eye - key.eye), 1e-12);
        if (&key == &path.keys.back()) continue;
    }
    const double h = 1e-5;
    const glm::dvec3 at = camera_at(path, 2).eye;
    const glm::dvec3 from = (at - camera_at(path, 2 - h).eye) / h,
                     to = (camera_at(path, 2 + h).eye - at) / h;
    EXPECT_LT(glm::length(from - to), 1e-3);
    // The slope between the neighbours: (2, 4, 0) in 3 seconds.
    EXPECT_LT(glm::length(to - glm::dvec3(2, 4, 0) / 3.0), 1e-3);
}

TEST(CameraPath, MatricesTurnOnTheShortestWay)
{
    // A quarter turn about y: from looking along -z to looking along -x.
    const CameraPath path = path_of(R"({"convention":"opengl","keys":[
        {"time":0,"camera_to_world":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]},
        {"time":1,"camera_to_world":[[0,0,1,2],[0,1,0,0],[-1,0,0,0],[0,0,0,1]]}]})");
    const Camera middle = camera_at(path, 0.5);
    const double half = std::sqrt(0.5);
    EXPECT_LT(glm::length(middle.direction - glm::dvec3(-half, 0, -half)), 1e-12);
    EXPECT_LT(glm::length(middle.up - glm::dvec3(0, 1, 0)), 1e-12);
    EXPECT_EQ(middle.eye, glm::dvec3(1, 0, 0));
    EXPECT_LT(glm::length(camera_at(path, 1).direction - glm::dvec3(-1, 0, 0)), 1e-12);
}

TEST(CameraPath, WhatIsNoPathIsRefusedWithItsPlace)
{
    EXPECT_EQ(path_refusal(R"({"keys":[]})"), ": keys: no array [...] with something in it");
    EXPECT_EQ(path_refusal(R"({"keys":[{"time":1,"eye":[0,0,0],"target":[0,0,0]}]})"),
        ": keys[0]: target: eye and target coincide, or the camera looks along its up");
    EXPECT_EQ(path_refusal(R"({"keys":[{"time":1,"eye":[0,0,1],"target":[0,0,0]},
                               {"time":1,"eye":[0,0,2],"target":[0,0,0]}]})"),
        ": keys[1]: time: is not above that of the key before");
    EXPECT_EQ(path_refusal(R"({"keys":[{"time":1,"eye":[0,0,1],"target":[0,0,0],"fov":180}]})"),
        ": keys[0]: fov: 180 degrees: accepted are above 0 and below 180");
    for (const char* text :
        {"", "{}", "[]", R"({"keys":[3]})", R"({"keys":[{"time":0}]})",
            R"({"keys":[{"time":"0","eye":[0,0,1],"target":[0,0,0]}]})",
            R"({"keys":[{"time":0,"eye":[0,0,1]}]})",
            R"({"keys":[{"time":0,"eye":[0,0],"target":[0,0,0]}]})",
            R"({"keys":[{"time":0,"eye":[0,0,1e40],"target":[0,0,0]}]})",
            R"({"fps":0,"keys":[{"time":0,"eye":[0,0,1],"target":[0,0,0]}]})",
            R"({"interpolation":"fast","keys":[{"time":0,"eye":[0,0,1],"target":[0,0,0]}]})",
            R"({"keys":[{"time":0,"camera_to_world":[[1,0,0,0],[0,1,0,0],[0,0,-1,0],[0,0,0,1]]}]})",
            R"({"keys":[{"time":0,"eye":[0,0,1],"target":[0,0,0]},
                         {"time":1,"camera_to_world":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]})"})
        EXPECT_NE(path_refusal(text), "no error") << text;
    EXPECT_THROW(camera_at({}, 0), ArgumentError);
}

} // namespace
} // namespace firsthit
