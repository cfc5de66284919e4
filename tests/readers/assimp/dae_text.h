// dae_text.h - small COLLADA files for tests.
#pragma once

#include <fmt/format.h>

#include <string>

namespace firsthit::test {

/// What varies; the rest is one quad of two materials' worth of nothing.
struct DaeText {
    std::string unit = "1";  // metres
    std::string up = "Y_UP"; // axis
    std::string libraries{}; // more of them
    std::string node{};      // more of what the node has
    std::string nodes{};     // more nodes
    std::string effect = "<phong><diffuse><color>0.5 0.25 0.125 1</color></diffuse></phong>";
    std::string positions = "0 0 0 2 0 0 2 1 0 0 1 0";
    std::string faces = "0 1 2 3";
    std::string images{};
};

inline std::string dae(const DaeText& with)
{
    return fmt::format(R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><created>2020-01-01T00:00:00Z</created><modified>2020-01-01T00:00:00Z</modified>
<unit name="u" meter="{unit}"/><up_axis>{up}</up_axis></asset>
{images}{libraries}
<library_effects><effect id="paint-fx"><profile_COMMON><technique sid="common">{effect}</technique>
</profile_COMMON></effect></library_effects>
<library_materials><material id="paint" name="paint"><instance_effect url="#paint-fx"/></material>
</library_materials>
<library_geometries><geometry id="quad" name="quad"><mesh>
<source id="quad-p"><float_array id="quad-pa" count="12">{positions}</float_array><technique_common>
<accessor source="#quad-pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="quad-v"><input semantic="POSITION" source="#quad-p"/></vertices>
<polylist material="m" count="1"><input semantic="VERTEX" source="#quad-v" offset="0"/>
<vcount>4</vcount><p>{faces}</p></polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s" name="s"><node id="arm" name="arm" type="NODE">
<translate sid="move">0 0 3</translate>{node}
<instance_geometry url="#quad"><bind_material><technique_common><instance_material symbol="m" target="#paint"/>
</technique_common></bind_material></instance_geometry></node>{nodes}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)",
        fmt::arg("unit", with.unit), fmt::arg("up", with.up), fmt::arg("images", with.images),
        fmt::arg("libraries", with.libraries), fmt::arg("effect", with.effect),
        fmt::arg("positions", with.positions), fmt::arg("faces", with.faces),
        fmt::arg("node", with.node), fmt::arg("nodes", with.nodes));
}

} // namespace firsthit::test
