// skins.cpp - the skins of a glTF document.
#include "readers/gltf/scene_maker.h"

#include <utility>

namespace firsthit::gltf {

/// Skins are numbered as in the document. Their nodes are known by now, wherever they are.
void SceneMaker::add_skins()
{
    for (std::size_t s = 0; s < document_.skins.size(); ++s) {
        const Skin& skin = document_.skins[s];
        firsthit::Skin made;
        made.name = skin.name;
        for (const int joint : skin.joints)
            made.joints.push_back(
                static_cast<std::uint32_t>(scene_node_[static_cast<std::size_t>(joint)]));
        made.inverse_bind.assign(skin.joints.size(), glm::dmat4(1));
        if (skin.inverse_bind_matrices != kNone) {
            const std::vector<glm::mat4> matrices =
                read_matrices(document_, skin.inverse_bind_matrices);
            for (std::size_t j = 0; j < skin.joints.size(); ++j)
                made.inverse_bind[j] = glm::dmat4(matrices[j]);
        }
        if (needs_identity_[s]) {
            made.joints.push_back(identity_node());
            made.inverse_bind.emplace_back(1);
        }
        builder_.add_skin(std::move(made));
    }
}

/// A node that stands still where the world's origin is.
std::uint32_t SceneMaker::identity_node()
{
    if (identity_node_ < 0)
        identity_node_ = static_cast<std::int32_t>(builder_.add_node({.name = "without joints"}));
    return static_cast<std::uint32_t>(identity_node_);
}

} // namespace firsthit::gltf
