// parse_light.h - a light by words of the command line.
#pragma once

#include <firsthit/light.h>

#include <string>

namespace firsthit::cli {

/// A light by its place:
///   point:x,y,z
///   spot:x,y,z,dx,dy,dz,DEG[,INNER]   full angles of the cone and of its evenly lit middle
///   directional:dx,dy,dz              the way the light goes
///   sun:LAT,LON,TIME                  as directional, in a world with x east, y up and z south: see turned_up
/// then, in any order, ,color=r,g,b (linear) ,intensity=I ,falloff=none|square (of point and spot) ,north=DEG
/// (of sun: where north is, clockwise from above, from where it is without it). "camera:" before it hangs it on
/// the camera: x right, y up, z towards the viewer.
/// throws  UsageError: the text and what is accepted; a sun below the horizon
Light parse_light(const std::string& text);

/// Whether parse_light makes a sun of a text.
bool is_sun(const std::string& text);

/// A direction of a world with y up, in one with another axis up: the up axis becomes that, by the rotation about x
/// (for z), or about z (for x and -y). In a world with z up, x is still east and y becomes north.
/// up_axis  one of the six axes
glm::dvec3 turned_up(const glm::dvec3& direction, const glm::dvec3& up_axis);

} // namespace firsthit::cli
