// real_vectors.inl - real2 and real3, vectors of `real`. Included inside the namespace of `real`.
//
// The subset of GLSL's vec2 and vec3 that src/glsl/ uses. All sums have a fixed order.

struct real2 {
    real x, y;
    real2() = default;
    FIRSTHIT_PURE real2(real x_, real y_) : x(x_), y(y_) {}
};

struct real3 {
    real x, y, z;
    real3() = default;
    FIRSTHIT_PURE real3(real x_, real y_, real z_) : x(x_), y(y_), z(z_) {}
};

FIRSTHIT_PURE real2 operator+(real2 a, real2 b)
{
    return real2(a.x + b.x, a.y + b.y);
}
FIRSTHIT_PURE real2 operator*(real2 a, real s)
{
    return real2(a.x * s, a.y * s);
}

FIRSTHIT_PURE real3 operator+(real3 a, real3 b)
{
    return real3(a.x + b.x, a.y + b.y, a.z + b.z);
}
FIRSTHIT_PURE real3 operator-(real3 a, real3 b)
{
    return real3(a.x - b.x, a.y - b.y, a.z - b.z);
}
FIRSTHIT_PURE real3 operator*(real3 a, real3 b)
{
    return real3(a.x * b.x, a.y * b.y, a.z * b.z);
}
FIRSTHIT_PURE real3 operator*(real3 a, real s)
{
    return real3(a.x * s, a.y * s, a.z * s);
}
FIRSTHIT_PURE real dot(real3 a, real3 b)
{
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
