// statements.h - what each statement of an AFF scene does.
#pragma once

#include "readers/aff/builder.h"
#include "readers/aff/lexer.h"

#include <firsthit/scene.h>

#include <cstdint>
#include <string>
#include <vector>

namespace firsthit::aff {

/// What statements change for those after them.
struct State {
    State(const AffFiles& files, const std::string& name, const LoadSettings& load_settings,
        std::vector<AffMeshRange>* mesh_ranges)
        : builder(files, name),
          settings(load_settings),
          meshes(mesh_ranges)
    {
    }

    Builder builder;
    const LoadSettings& settings;
    std::vector<AffMeshRange>* meshes; // null where the caller did not ask for them
    std::string material_name;         // the statement's place
    Phong material;
    std::int64_t detail = 0;
    std::uint32_t node = 0;   // that shapes belong to
    std::string camera_place; // of the `v`
};

// Each reads the operands of one statement, whose keyword is taken already.

// world_statements.cpp
void read_view(Lexer& lexer, State& state);            // v
void read_light(Lexer& lexer, State& state);           // l
void read_moving_light(Lexer& lexer, State& state);    // la
void read_background(Lexer& lexer, State& state);      // b
void read_ambient(Lexer& lexer, State& state);         // am
void read_animation(Lexer& lexer, State& state);       // a
void read_detail(Lexer& lexer, State& state);          // d
void read_simple_material(Lexer& lexer, State& state); // f
void read_full_material(Lexer& lexer, State& state);   // fm

// shapes.cpp
void read_sphere(Lexer& lexer, State& state);                   // s
void read_cone(Lexer& lexer, State& state);                     // c
void read_polygon(Lexer& lexer, State& state);                  // p
void read_smooth_polygon(Lexer& lexer, State& state);           // pp
void read_textured_triangle(Lexer& lexer, State& state);        // tt
void read_textured_smooth_triangle(Lexer& lexer, State& state); // ttp
void read_animated_triangle(Lexer& lexer, State& state);        // tpa

// platonic.cpp, of extended NFF
void read_tetrahedron(Lexer& lexer, State& state);  // tet
void read_cube(Lexer& lexer, State& state);         // hex
void read_octahedron(Lexer& lexer, State& state);   // oct
void read_dodecahedron(Lexer& lexer, State& state); // dod

// mesh.cpp
void read_mesh(Lexer& lexer, State& state); // m

// tracks.cpp
void read_track(Lexer& lexer, State& state); // k

} // namespace firsthit::aff
