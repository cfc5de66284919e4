// default_material.cpp - what triangles look like that come without a material.
#include "scene/model/default_material.h"

namespace firsthit {

Material default_material()
{
    Material grey;
    grey.name = "grey";
    grey.model = Phong{.ambient = glm::vec3(0.6f),
        .diffuse = glm::vec3(0.6f),
        .specular = glm::vec3(0.2f),
        .shininess = 30.0f};
    return grey;
}

} // namespace firsthit
