// read_animations.cpp - the animations of a glTF document.
#include "readers/gltf/document/check_attributes.h"
#include "readers/gltf/document/loader.h"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <utility>

namespace firsthit::gltf {
namespace {

AnimationSampler read_animation_sampler(Loader& loader, const Place& place)
{
    const std::size_t accessors = loader.document.accessors.size();
    AnimationSampler sampler;
    sampler.input = place.required_index("input", accessors);
    sampler.output = place.required_index("output", accessors);
    check_type(loader, place, "input", sampler.input, {ElementType::kScalar});
    const Accessor& input = loader.document.accessors[std::size_t(sampler.input)];
    if (input.component != ComponentType::kFloat)
        place.fail("input", fmt::format("componentType {} is not accepted; accepted is 5126",
                                static_cast<int>(input.component)));
    const std::string interpolation = place.text("interpolation");
    if (interpolation == "STEP")
        sampler.interpolation = Interpolation::kStep;
    else if (interpolation == "CUBICSPLINE")
        sampler.interpolation = Interpolation::kCubicSpline;
    else if (interpolation != "LINEAR" && !interpolation.empty())
        place.fail("interpolation",
            fmt::format(
                "'{}' is not accepted; accepted are LINEAR, STEP, CUBICSPLINE", interpolation));
    return sampler;
}

std::optional<AnimatedProperty> property_of(const std::string& path)
{
    if (path == "translation") return AnimatedProperty::kTranslation;
    if (path == "rotation") return AnimatedProperty::kRotation;
    if (path == "scale") return AnimatedProperty::kScale;
    if (path == "weights") return AnimatedProperty::kWeights;
    return std::nullopt;
}

std::size_t target_count(const Document& document, int node)
{
    const int mesh = document.nodes[std::size_t(node)].mesh;
    if (mesh == kNone || document.meshes[std::size_t(mesh)].primitives.empty()) return 0;
    return document.meshes[std::size_t(mesh)].primitives[0].targets.size();
}

/// The sampler's output fits what the channel moves.
void check_output(Loader& loader, const Place& place, const AnimationSampler& sampler,
    const AnimationChannel& channel)
{
    const Document& document = loader.document;
    using enum ElementType;
    std::size_t values = 1; // a key
    switch (channel.property) {
    case AnimatedProperty::kTranslation:
    case AnimatedProperty::kScale:
        check_type(loader, place, "sampler", sampler.output, {kVec3});
        break;
    case AnimatedProperty::kRotation:
        check_type(loader, place, "sampler", sampler.output, {kVec4});
        break;
    case AnimatedProperty::kWeights:
        check_type(loader, place, "sampler", sampler.output, {kScalar});
        values = target_count(document, channel.node);
        break;
    }
    if (sampler.interpolation == Interpolation::kCubicSpline) values *= 3;
    const Accessor& output = document.accessors[std::size_t(sampler.output)];
    const std::size_t keys = document.accessors[std::size_t(sampler.input)].count;
    if (output.count < keys * values)
        place.fail("sampler", fmt::format("its output has {} values for {} keys, {} are needed",
                                  output.count, keys, keys * values));
    if (output.count > keys * values)
        loader.warn("output", fmt::format("{}: its output has {} values for {} keys, {} are used",
                                  place.path(), output.count, keys, keys * values));
    if (output.component == ComponentType::kUnsignedInt ||
        (output.component != ComponentType::kFloat && !output.normalized))
        loader.warn(
            "output type", fmt::format("{}: its output has components of an unusual type ({})",
                               place.path(), static_cast<int>(output.component)));
}

} // namespace

void read_animations(Loader& loader)
{
    Document& document = loader.document;
    loader.root.each("animations", [&](std::size_t, const Place& place) {
        Animation animation;
        animation.name = place.text("name");
        place.each("samplers", [&](std::size_t, const Place& sampler) {
            animation.samplers.push_back(read_animation_sampler(loader, sampler));
        });
        std::set<std::pair<int, AnimatedProperty>> moved;
        place.each("channels", [&](std::size_t, const Place& entry) {
            AnimationChannel channel;
            channel.sampler = entry.required_index("sampler", animation.samplers.size());
            const std::optional<Place> target = entry.find("target");
            if (!target) entry.fail("target", "is missing");
            channel.node = target->index("node", document.nodes.size());
            const std::string path = target->text("path");
            const std::optional<AnimatedProperty> property = property_of(path);
            if (!property) {
                loader.warn("path " + path,
                    fmt::format("{}: the animation of '{}' is not shown", target->path(), path));
                return;
            }
            if (channel.node == kNone) return; // the specification ignores it
            channel.property = *property;
            if (channel.property == AnimatedProperty::kWeights &&
                target_count(document, channel.node) == 0) {
                loader.warn("moved weights",
                    fmt::format("{}: node {} has no morph targets", target->path(), channel.node));
                return;
            }
            if (!moved.emplace(channel.node, channel.property).second) {
                loader.warn("moved twice",
                    fmt::format("{}: the {} of node {} is animated twice; the first one is used",
                        entry.path(), path, channel.node));
                return;
            }
            const AnimationSampler& sampler = animation.samplers[std::size_t(channel.sampler)];
            if (document.accessors[std::size_t(sampler.input)].count == 0) {
                loader.warn("no keys", fmt::format("{} has no keys", entry.path()));
                return;
            }
            check_output(loader, entry, sampler, channel);
            if (channel.property != AnimatedProperty::kWeights &&
                document.nodes[std::size_t(channel.node)].matrix)
                loader.warn("moved matrix",
                    fmt::format("{}: node {} has a matrix, which an animation replaces",
                        entry.path(), channel.node));
            animation.channels.push_back(channel);
        });
        document.animations.push_back(std::move(animation));
    });
}

} // namespace firsthit::gltf
