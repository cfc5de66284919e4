// unlit.glsl - a surface that shows its own colour, independently of all lights.

struct UnlitInputs {
    real3 color;
};

FIRSTHIT_PURE UnlitInputs inputs_of(Unlit material, MapColors maps)
{
    UnlitInputs inputs;
    inputs.color = all_lanes(material.color) * maps.map[0].rgb;
    return inputs;
}

FIRSTHIT_PURE real3 albedo(UnlitInputs inputs)
{
    return inputs.color;
}

FIRSTHIT_PURE real3 emitted(UnlitInputs inputs, FIRSTHIT_UNUSED vec3 ambient_light)
{
    return inputs.color;
}
