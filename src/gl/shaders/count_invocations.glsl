// count_invocations.glsl - counts the invocations of a shader, for tests.

#ifdef FIRSTHIT_COUNT_INVOCATIONS
layout(std430, binding = kResultBlock) buffer Invocations { uint invocations; };
#endif

void count_invocation()
{
#ifdef FIRSTHIT_COUNT_INVOCATIONS
    atomicAdd(invocations, 1u);
#endif
}
