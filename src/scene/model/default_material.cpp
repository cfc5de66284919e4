// default_material.cpp - what triangles look like that come without a material.
#include "scene/model/default_material.h"

namespace firsthit {

Material default_material()
{
    Material grey;
    grey.name = "grey";
    grey.ambient = glm::vec3(0.6f);
    grey.diffuse = glm::vec3(0.6f);
    grey.specular = glm::vec3(0.2f);
    grey.shininess = 30.0f;
    return grey;
}

} // namespace firsthit
