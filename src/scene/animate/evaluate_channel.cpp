// evaluate_channel.cpp - step, linear and cubic interpolation between keys.
#include "scene/animate/evaluate_channel.h"

#include "scene/animate/tcb_spline.h"

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

/// Two neighbouring keys and how far the time is from the first to the second, 0 to 1.
struct Interval {
    std::size_t a = 0;
    std::size_t b = 0;
    double u = 0;
    double length_s = 0;
};

Interval interval_at(const std::vector<double>& time_s, double t)
{
    const std::size_t last = time_s.size() - 1;
    if (!(t > time_s.front())) return {0, 0, 0, 0};
    if (t >= time_s.back()) return {last, last, 0, 0};
    const auto after = std::upper_bound(time_s.begin(), time_s.end(), t);
    const auto b = static_cast<std::size_t>(after - time_s.begin());
    const double length_s = time_s[b] - time_s[b - 1];
    return {b - 1, b, length_s > 0 ? (t - time_s[b - 1]) / length_s : 0.0, length_s};
}

/// The last key, in the order of the file, that is not after the time: times of AFF may go back.
std::size_t step_at(const std::vector<double>& time_s, double t)
{
    std::size_t last = 0;
    for (std::size_t k = 0; k < time_s.size(); ++k)
        if (time_s[k] <= t) last = k;
    return last;
}

glm::dquat quaternion(std::span<const double> value)
{
    return glm::dquat(value[3], value[0], value[1], value[2]);
}

/// The identity where there is no direction to keep.
glm::dquat unit(const glm::dquat& q)
{
    const double length = std::sqrt(glm::dot(q, q));
    return length > 0 && std::isfinite(length) ? q * (1 / length) : glm::dquat(1, 0, 0, 0);
}

void store(const glm::dquat& q, std::span<double> value)
{
    value[0] = q.x;
    value[1] = q.y;
    value[2] = q.z;
    value[3] = q.w;
}

/// On the great arc, the short way. Where the angle is tiny the chord is the arc.
glm::dquat slerp(const glm::dquat& from, glm::dquat to, double u)
{
    double cosine = glm::dot(from, to);
    if (cosine < 0) {
        to = -to;
        cosine = -cosine;
    }
    if (cosine > 1 - 1e-12) return unit(from * (1 - u) + to * u);
    const double angle = std::acos(std::min(cosine, 1.0));
    return unit(from * std::sin((1 - u) * angle) + to * std::sin(u * angle));
}

void evaluate_linear(const Channel& channel, const Interval& at, std::span<double> value)
{
    const std::size_t size = components_of(channel);
    const double* a = channel.value.data() + at.a * size;
    const double* b = channel.value.data() + at.b * size;
    if (channel.path == Channel::Path::rotation) {
        store(slerp(unit(quaternion({a, 4})), unit(quaternion({b, 4})), at.u), value);
        return;
    }
    const std::size_t count = std::min(size, value.size());
    for (std::size_t c = 0; c < count; ++c) value[c] = (1 - at.u) * a[c] + at.u * b[c];
}

/// Each key has three values: the tangent that arrives, the value, the tangent that leaves.
void evaluate_cubic(const Channel& channel, const Interval& at, std::span<double> value)
{
    const std::size_t size = components_of(channel);
    const double* a = channel.value.data() + at.a * 3 * size;
    const double* b = channel.value.data() + at.b * 3 * size;
    const double u = at.u, u2 = u * u, u3 = u2 * u;
    const double from = 2 * u3 - 3 * u2 + 1, leave = at.length_s * (u3 - 2 * u2 + u);
    const double to = 3 * u2 - 2 * u3, arrive = at.length_s * (u3 - u2);
    const std::size_t count = std::min(size, value.size());
    for (std::size_t c = 0; c < count; ++c)
        value[c] = from * a[size + c] + leave * a[2 * size + c] + to * b[size + c] + arrive * b[c];
    if (channel.path == Channel::Path::rotation) store(unit(quaternion(value)), value);
}

void evaluate_tcb(const Channel& channel, double time_s, std::span<double> value)
{
    if (channel.path == Channel::Path::rotation) {
        store(evaluate_rotation(channel.tcb, time_s), value);
        return;
    }
    const glm::dvec3 vector = evaluate_vector(channel.tcb, time_s);
    for (std::size_t c = 0; c < std::min<std::size_t>(3, value.size()); ++c)
        value[c] = vector[static_cast<int>(c)];
}

} // namespace

std::size_t components_of(const Channel& channel)
{
    switch (channel.path) {
    case Channel::Path::translation:
    case Channel::Path::scale:
        return 3;
    case Channel::Path::rotation:
        return 4;
    case Channel::Path::visibility:
        return 1;
    case Channel::Path::weights:
        break;
    }
    const std::size_t values = channel.interpolation == Channel::Interpolation::cubic ? 3 : 1;
    return channel.time_s.empty() ? 0 : channel.value.size() / (values * channel.time_s.size());
}

void evaluate(const Channel& channel, double time_s, std::span<double> value)
{
    switch (channel.interpolation) {
    case Channel::Interpolation::tcb:
        evaluate_tcb(channel, time_s, value);
        break;
    case Channel::Interpolation::linear:
        evaluate_linear(channel, interval_at(channel.time_s, time_s), value);
        break;
    case Channel::Interpolation::cubic:
        evaluate_cubic(channel, interval_at(channel.time_s, time_s), value);
        break;
    case Channel::Interpolation::step: {
        // Visibility of AFF may have times in any order; all others are in order.
        const std::size_t key = channel.path == Channel::Path::visibility
                                    ? step_at(channel.time_s, time_s)
                                    : interval_at(channel.time_s, time_s).a;
        evaluate_linear(channel, {key, key, 0, 0}, value);
        break;
    }
    }
}

glm::dmat4 matrix_of(const NodeTransform& transform)
{
    glm::dmat4 matrix = glm::mat4_cast(transform.rotation);
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= transform.scale[axis];
    matrix[3] = glm::dvec4(transform.translation, 1.0);
    return matrix;
}

} // namespace firsthit
