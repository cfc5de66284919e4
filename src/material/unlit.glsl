// unlit.glsl - a surface that shows its colour whatever the lights are.

struct UnlitInputs {
    real3 color;
};

FIRSTHIT_PURE UnlitInputs inputs_of(Unlit material, real3 texture_color)
{
    UnlitInputs inputs;
    inputs.color = all_lanes(material.color) * texture_color;
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
