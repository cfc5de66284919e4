// scene_test.cpp - the nodes, skins, cameras, lights and animations of glTF documents.
#include "readers/gltf/gltf_text.h"

#include <gtest/gtest.h>

namespace firsthit::gltf {
namespace {

/// Accessors of a type, all of them zeros.
std::string accessor(const std::string& type, int count, int component = 5126)
{
    return R"({"componentType": )" + std::to_string(component) + R"(, "count": )" +
           std::to_string(count) + R"(, "type": ")" + type + "\"}";
}

std::string warned(const std::string& members)
{
    return warnings_of(read_members(members));
}

TEST(GltfNodes, ReadsTransformsAndTrees)
{
    const Document document =
        read_members(R"("scene": 1, "scenes": [{}, {"name": "s", "nodes": [2]}], "nodes": [
        {"name": "a", "translation": [1, 2, 3], "rotation": [0, 0, 1, 0], "scale": [2, 2, -2]},
        {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]}, {"children": [0, 1]}])");
    EXPECT_EQ(document.scene, 1);
    EXPECT_EQ(document.scenes[1].nodes, std::vector<int>{2});
    EXPECT_EQ(document.nodes[0].name, "a");
    EXPECT_EQ(document.nodes[0].translation, glm::vec3(1, 2, 3));
    EXPECT_EQ(document.nodes[0].rotation.z, 1.0f);
    EXPECT_EQ(document.nodes[0].rotation.w, 0.0f);
    EXPECT_EQ(document.nodes[0].scale, glm::vec3(2, 2, -2));
    EXPECT_EQ(document.nodes[0].parent, 2);
    EXPECT_FALSE(document.nodes[0].matrix);
    EXPECT_EQ((*document.nodes[1].matrix)[3], glm::vec4(5, 6, 7, 1));
    EXPECT_EQ(document.nodes[2].parent, kNone);
}

TEST(GltfNodes, RefusesWhatIsNoTree)
{
    EXPECT_EQ(refusal(R"("nodes": [{"children": [1]}, {"children": [0]}])"),
        "t.gltf: nodes[0]: is on a cycle of nodes, or below one");
    EXPECT_EQ(refusal(R"("nodes": [{"children": [0]}])"),
        "t.gltf: nodes[0]: is on a cycle of nodes, or below one");
    EXPECT_EQ(refusal(R"("nodes": [{"children": [2]}, {"children": [2]}, {}])"),
        "t.gltf: nodes[1].children: node 2 is already a child of node 0; accepted is one parent");
    EXPECT_EQ(refusal(R"("nodes": [{"children": [1, 1]}, {}])"),
        "t.gltf: nodes[0].children: node 1 is already a child of node 0; accepted is one parent");
    EXPECT_EQ(refusal(R"("nodes": [{"children": [1]}, {}], "scenes": [{"nodes": [1]}])"),
        "t.gltf: scenes[0].nodes: node 1 is a child of node 0; accepted are roots");
    EXPECT_EQ(refusal(R"("nodes": [{}], "scenes": [{"nodes": [0, 0]}])"),
        "t.gltf: scenes[0].nodes: node 0 is named twice");
}

TEST(GltfNodes, LimitsTheDepthOfTrees)
{
    const auto chain = [](int depth) {
        std::string nodes = "{}";
        for (int k = 1; k < depth; ++k)
            nodes += R"(, {"children": [)" + std::to_string(k - 1) + "]}";
        return R"("nodes": [)" + nodes + "]";
    };
    EXPECT_EQ(refusal(chain(1024)), "no error");
    EXPECT_EQ(refusal(chain(1025)), "t.gltf: nodes[0]: is more than 1024 nodes below its root");
}

TEST(GltfNodes, WarnsOfContradictions)
{
    EXPECT_EQ(
        warned(
            R"("nodes": [{"matrix": [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], "scale": [1, 1, 1]},
        {"rotation": [0, 0, 0, 2], "weights": [1]}], "scenes": [{}])"),
        "t.gltf: nodes[0] has a matrix and translation, rotation or scale; the matrix is used\n"
        "t.gltf: the last row of nodes[0].matrix is taken as 0, 0, 0, 1\n"
        "t.gltf: nodes[1].rotation has length 2 instead of 1\n"
        "t.gltf: nodes[1] has weights, but no mesh\n"
        "t.gltf: scenes[0] has no nodes\n");
}

TEST(GltfNodes, ReadsInstances)
{
    const std::string mesh =
        R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "accessors": [)" +
        accessor("VEC3", 3) + "," + accessor("VEC4", 3) + "," + accessor("VEC3", 4) + "]";
    const auto node = [&](const std::string& attributes) {
        return mesh +
               R"(, "nodes": [{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {)" +
               attributes + "}}}}]";
    };
    const Document document = read_members(node(R"("TRANSLATION": 0, "ROTATION": 1, "_ID": 2)"));
    EXPECT_EQ(document.nodes[0].instancing,
        (std::map<std::string, int>{{"ROTATION", 1}, {"TRANSLATION", 0}}));
    EXPECT_EQ(refusal(node(R"("TRANSLATION": 0, "SCALE": 2)")),
        "t.gltf: nodes[0].EXT_mesh_gpu_instancing.attributes.TRANSLATION: accessor 0 has 3 "
        "elements, SCALE has 4");
    EXPECT_EQ(refusal(node(R"("ROTATION": 0)")),
        "t.gltf: nodes[0].EXT_mesh_gpu_instancing.attributes.ROTATION: accessor 0 is of type VEC3; "
        "accepted is VEC4");
}

TEST(GltfMeshes, ChecksAttributes)
{
    const auto mesh = [](const std::string& primitive, const std::string& accessors) {
        return R"("accessors": [)" + accessors + R"(], "meshes": [{"primitives": [{)" + primitive +
               "}]}]";
    };
    const std::string three = accessor("VEC3", 3);
    const Document document = read_members(
        mesh(R"("mode": 5, "attributes": {"POSITION": 0, "_A": 1}, "targets": [{"POSITION": 0}])",
            three + "," + accessor("MAT2", 3)));
    EXPECT_EQ(document.meshes[0].primitives[0].mode, PrimitiveMode::kTriangleStrip);
    EXPECT_EQ(document.meshes[0].primitives[0].attributes.at("_A"), 1);
    EXPECT_EQ(document.meshes[0].primitives[0].targets.size(), 1u);
    EXPECT_EQ(warnings_of(document), "");

    EXPECT_EQ(refusal(mesh(R"("mode": 7, "attributes": {})", three)),
        "t.gltf: meshes[0].primitives[0].mode: 7 is not accepted, a whole number from 0 to 6 is");
    EXPECT_EQ(refusal(mesh(R"("attributes": {"POSITION": 0})", accessor("VEC2", 3))),
        "t.gltf: meshes[0].primitives[0].attributes.POSITION: accessor 0 is of type VEC2; accepted "
        "is VEC3");
    EXPECT_EQ(refusal(mesh(R"("attributes": {"COLOR_0": 0})", accessor("VEC2", 3))),
        "t.gltf: meshes[0].primitives[0].attributes.COLOR_0: accessor 0 is of type VEC2; accepted "
        "is VEC3 or VEC4");
    EXPECT_EQ(refusal(mesh(R"("attributes": {"NORMAL": 0, "POSITION": 1})",
                  three + "," + accessor("VEC3", 4))),
        "t.gltf: meshes[0].primitives[0].attributes.POSITION: accessor 1 has 4 elements, others of "
        "the primitive have 3");
    EXPECT_EQ(refusal(mesh(R"("attributes": {"POSITION": 0}, "targets": [{"POSITION": 1}])",
                  three + "," + accessor("VEC3", 4))),
        "t.gltf: meshes[0].primitives[0].targets[0].POSITION: accessor 1 has 4 elements, others of "
        "the primitive have 3");
    EXPECT_EQ(refusal(mesh(R"("attributes": {"JOINTS_0": 0})", accessor("VEC4", 3))),
        "t.gltf: meshes[0].primitives[0].attributes.JOINTS_0: componentType 5126 is not accepted; "
        "accepted are 5121, 5123");
    EXPECT_EQ(refusal(mesh(R"("attributes": {"POSITION": 0}, "indices": 0)", three)),
        "t.gltf: meshes[0].primitives[0].indices: accessor 0 is of type VEC3; accepted is SCALAR");
    EXPECT_EQ(refusal(mesh(R"("attributes": {"POSITION": 0}, "indices": 1)",
                  three + "," + accessor("SCALAR", 3))),
        "t.gltf: meshes[0].primitives[0].indices: accessor 1 has componentType 5126; accepted are "
        "5121, 5123, 5125");
    EXPECT_EQ(refusal(mesh(R"("attributes": {"POSITION": 0})",
                          R"({"componentType": 5126, "count": 1, "type": "X"})"))
                  .substr(0, 75),
        "t.gltf: meshes[0].primitives[0].attributes.POSITION: accessor 0 cannot be r");
}

TEST(GltfMeshes, WarnsOnceOfEachKind)
{
    const std::string primitive = R"({"attributes": {"COORDS": 0}, "targets": [{"NORMAL": 0}]})";
    EXPECT_EQ(warned(R"("accessors": [)" + accessor("VEC3", 4) +
                     R"(], "meshes": [{"primitives": [)" + primitive + "," + primitive + "]}]"),
        "t.gltf: meshes[0].primitives[0]: the attribute 'COORDS' is unknown and not used\n"
        "t.gltf: meshes[0].primitives[0]: morph targets change NORMAL, which the primitive does "
        "not have\n"
        "t.gltf: meshes[0].primitives[0]: there is no POSITION; the primitive is not shown\n"
        "t.gltf: meshes[0].primitives[0]: 4 corners are no whole triangles\n");
}

TEST(GltfMeshes, GivesAllPrimitivesEquallyManyTargets)
{
    const Document document = read_members(R"("accessors": [)" + accessor("VEC3", 3) +
                                           R"(], "meshes": [{"weights": [1], "primitives": [
        {"attributes": {"POSITION": 0}}, {"attributes": {"POSITION": 0}, "targets": [{"POSITION": 0}, {"POSITION": 0}]}]}],
        "nodes": [{"mesh": 0, "weights": [1, 2, 3]}])");
    EXPECT_EQ(document.meshes[0].primitives[0].targets.size(), 2u);
    EXPECT_EQ(document.meshes[0].weights, (std::vector<float>{1, 0}));
    EXPECT_EQ(document.nodes[0].weights, (std::vector<float>{1, 2}));
    EXPECT_EQ(warnings_of(document), "t.gltf: the primitives of meshes[0] have unequal numbers of "
                                     "morph targets; missing ones change nothing\n"
                                     "t.gltf: meshes[0] has 1 weights for 2 morph targets\n");
}

TEST(GltfSkins, ChecksJointsAndMatrices)
{
    const auto skin = [](const std::string& members, const std::string& accessors) {
        return R"("nodes": [{"children": [1]}, {}, {}], "accessors": [)" + accessors +
               R"(], "skins": [{)" + members + "}]";
    };
    EXPECT_EQ(
        read_members(skin(R"("joints": [1, 0], "inverseBindMatrices": 0)", accessor("MAT4", 2)))
            .skins[0]
            .joints,
        (std::vector<int>{1, 0}));
    EXPECT_EQ(refusal(skin("", "")), "t.gltf: skins[0].joints: is missing or empty");
    EXPECT_EQ(refusal(skin(R"("joints": [3])", "")),
        "t.gltf: skins[0].joints: 3 is out of range, there are 3");
    EXPECT_EQ(refusal(skin(R"("joints": [1, 0], "inverseBindMatrices": 0)", accessor("MAT4", 1))),
        "t.gltf: skins[0].inverseBindMatrices: 1 matrices for 2 joints");
    EXPECT_EQ(refusal(skin(R"("joints": [1], "inverseBindMatrices": 0)", accessor("MAT3", 1))),
        "t.gltf: skins[0].inverseBindMatrices: accessor 0 is of type MAT3; accepted is MAT4");
    EXPECT_EQ(
        refusal(skin(R"("joints": [1], "inverseBindMatrices": 0)", accessor("MAT4", 1, 5123))),
        "t.gltf: skins[0].inverseBindMatrices: componentType 5123 is not accepted; accepted is "
        "5126");
    EXPECT_EQ(warned(skin(R"("joints": [1, 0, 0, 2])", "")),
        "t.gltf: skins[0] names a joint twice\nt.gltf: the joints of skins[0] have no common "
        "root\n");
    EXPECT_EQ(warned(skin(R"("joints": [0])", "") + R"(, "meshes": [{"primitives": []}])")
                      .find("no primitives") != std::string::npos,
        true);
}

TEST(GltfCameras, ReadsAndChecksLenses)
{
    const auto camera = [](const std::string& members) {
        return R"("cameras": [{)" + members + "}]";
    };
    const Camera perspective = read_members(
        camera(
            R"("type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.25, "aspectRatio": 2})"))
                                   .cameras[0];
    EXPECT_EQ(perspective.y_fov_rad, 0.5f);
    EXPECT_EQ(perspective.aspect, 2.0f);
    EXPECT_EQ(perspective.z_far, 0.0f);
    const Camera flat = read_members(
        camera(
            R"("type": "orthographic", "orthographic": {"xmag": -2, "ymag": 3, "znear": 0, "zfar": 9})"))
                            .cameras[0];
    EXPECT_TRUE(flat.orthographic);
    EXPECT_EQ(flat.x_mag, 2.0f);
    EXPECT_EQ(refusal(camera(R"("type": "fisheye")")),
        "t.gltf: cameras[0].type: 'fisheye' is not accepted; accepted are perspective, "
        "orthographic");
    EXPECT_EQ(
        refusal(camera(R"("type": "perspective")")), "t.gltf: cameras[0].perspective: is missing");
    EXPECT_EQ(refusal(camera(R"("type": "perspective", "perspective": {"yfov": 0, "znear": 1})")),
        "t.gltf: cameras[0].perspective.yfov: 0 is not accepted, above 0 is");
    EXPECT_EQ(refusal(camera(R"("type": "perspective", "perspective": {"yfov": 1, "znear": 0})")),
        "t.gltf: cameras[0].perspective.znear: 0 is not accepted, above 0 is");
    EXPECT_EQ(refusal(camera(
                  R"("type": "perspective", "perspective": {"yfov": 1, "znear": 2, "zfar": 1})")),
        "t.gltf: cameras[0].perspective.zfar: 1 is not accepted, above znear (2) is");
    EXPECT_EQ(
        refusal(camera(
            R"("type": "orthographic", "orthographic": {"xmag": 0, "ymag": 3, "znear": 0, "zfar": 9})")),
        "t.gltf: cameras[0].orthographic: xmag or ymag is 0");
    EXPECT_EQ(warned(camera(R"("type": "perspective", "perspective": {"yfov": 4, "znear": 1})")),
        "t.gltf: cameras[0].perspective.yfov is 4, 3.13 is used\n");
}

TEST(GltfLights, ReadsAndRepairs)
{
    const auto light = [](const std::string& members) {
        return R"("extensions": {"KHR_lights_punctual": {"lights": [{)" + members +
               R"(}]}}, "nodes": [{"extensions": {"KHR_lights_punctual": {"light": 0}}}])";
    };
    const Document document = read_members(light(
        R"("type": "spot", "color": [1, 0.5, 0], "intensity": 20, "range": 5, "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.5})"));
    EXPECT_EQ(document.nodes[0].light, 0);
    EXPECT_EQ(document.lights[0].type, LightType::kSpot);
    EXPECT_EQ(document.lights[0].color, glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(document.lights[0].intensity, 20.0f);
    EXPECT_EQ(document.lights[0].range, 5.0f);
    EXPECT_EQ(document.lights[0].inner_cone_rad, 0.25f);
    EXPECT_EQ(document.lights[0].outer_cone_rad, 0.5f);
    EXPECT_EQ(
        warned(light(R"("type": "spot", "spot": {"innerConeAngle": 0.75, "outerConeAngle": 0.5})")),
        "t.gltf: KHR_lights_punctual.lights[0].spot: angles from 0.75 to 0.5 are no cone; 0.5 to "
        "0.5 is used\n");
    EXPECT_EQ(warned(light(R"("type": "area")")),
        "t.gltf: KHR_lights_punctual.lights[0].type 'area' is none of directional, point, spot; "
        "the light is dark\n");
    EXPECT_EQ(warned(light(R"("type": "point", "intensity": -1)")),
        "t.gltf: KHR_lights_punctual.lights[0] has a negative colour, intensity or range; 0 is "
        "used\n");
}

TEST(GltfAnimations, ChecksChannelsAgainstWhatTheyMove)
{
    const auto animation = [](const std::string& output, const std::string& sampler,
                               const std::string& target) {
        return R"("accessors": [)" + accessor("SCALAR", 2) + "," + output + "," +
               accessor("VEC3", 3) +
               R"(], "meshes": [{"primitives": [{"attributes": {"POSITION": 2}, "targets": [{"POSITION": 2}, {}]}]}],
               "nodes": [{"mesh": 0}, {}], "animations": [{"samplers": [{"input": 0, "output": 1)" +
               sampler + R"(}], "channels": [{"sampler": 0, "target": {)" + target + "}}]}]";
    };
    const std::string step = R"(, "interpolation": "STEP")",
                      cubic = R"(, "interpolation": "CUBICSPLINE")";
    const Document document =
        read_members(animation(accessor("SCALAR", 12), cubic, R"("node": 0, "path": "weights")"));
    EXPECT_EQ(document.animations[0].samplers[0].interpolation, Interpolation::kCubicSpline);
    ASSERT_EQ(document.animations[0].channels.size(), 1u);
    EXPECT_EQ(document.animations[0].channels[0].property, AnimatedProperty::kWeights);

    EXPECT_EQ(refusal(animation(accessor("VEC3", 1), step, R"("node": 1, "path": "scale")")),
        "t.gltf: animations[0].channels[0].sampler: its output has 1 values for 2 keys, 2 are "
        "needed");
    EXPECT_EQ(refusal(animation(accessor("VEC3", 2), step, R"("node": 1, "path": "rotation")")),
        "t.gltf: animations[0].channels[0].sampler: accessor 1 is of type VEC3; accepted is VEC4");
    EXPECT_EQ(refusal(animation(accessor("VEC3", 2), R"(, "interpolation": "X")",
                  R"("node": 1, "path": "scale")")),
        "t.gltf: animations[0].samplers[0].interpolation: 'X' is not accepted; accepted are "
        "LINEAR, STEP, CUBICSPLINE");
    EXPECT_EQ(warned(animation(accessor("VEC3", 2), step, R"("path": "scale")")), "");
    EXPECT_EQ(warned(animation(accessor("VEC3", 2), step, R"("node": 1, "path": "pointer")")),
        "t.gltf: animations[0].channels[0].target: the animation of 'pointer' is not shown\n");
    EXPECT_EQ(warned(animation(accessor("SCALAR", 2), step, R"("node": 1, "path": "weights")")),
        "t.gltf: animations[0].channels[0].target: node 1 has no morph targets\n");
    EXPECT_EQ(warned(animation(accessor("VEC3", 3), "", R"("node": 1, "path": "scale")")),
        "t.gltf: animations[0].channels[0]: its output has 3 values for 2 keys, 2 are used\n");
    EXPECT_EQ(
        warned(animation(accessor("VEC3", 2), "",
            R"("node": 1, "path": "scale"}}, {"sampler": 0, "target": {"node": 1, "path": "scale")")),
        "t.gltf: animations[0].channels[1]: the scale of node 1 is animated twice; the first one "
        "is used\n");
}

} // namespace
} // namespace firsthit::gltf
