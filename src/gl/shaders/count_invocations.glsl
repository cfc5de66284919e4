// count_invocations.glsl - counts the samples that a shader runs for, for tests.

#ifdef FIRSTHIT_COUNT_INVOCATIONS
layout(std430, binding = 0) buffer Invocations { uint invocations; };
#endif

void count_invocation()
{
#ifdef FIRSTHIT_COUNT_INVOCATIONS
    atomicAdd(invocations, 1u);
#endif
}
