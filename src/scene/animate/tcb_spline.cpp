// tcb_spline.cpp - Kochanek-Bartels splines of places, scales and rotations.
#include "scene/animate/tcb_spline.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace firsthit {
namespace {

/// Below this sine an angle counts as zero, as in BART's own code (pictures should agree).
constexpr double kSmallSine = 1e-3;

/// The piece of a spline that a time falls into: between keys b and b + 1, u of the way.
struct Piece {
    std::size_t b = 1;
    double u = 0;
};

/// keys  at least four
Piece find_piece(const std::vector<TcbKey>& keys, double time_s)
{
    const std::size_t last = keys.size() - 2;
    if (time_s <= keys[1].time_s) return {1, 0.0};
    if (time_s >= keys[last].time_s) return {last - 1, 1.0};
    // In order, because times can go backwards. The last piece ends after the time, so one is
    // found, and it starts no later than the time, as otherwise the one before it would have been
    // taken.
    std::size_t b = 1;
    while (time_s >= keys[b + 1].time_s) ++b;
    return {b, (time_s - keys[b].time_s) / (keys[b + 1].time_s - keys[b].time_s)};
}

/// How much of the step before and after a key goes into the tangent there.
struct Weights {
    double before = 0;
    double after = 0;
};

/// Half of how much the piece's speed must change for keys that are not equally far apart in time.
double spacing(double part, double whole)
{
    return whole != 0 ? part / whole : 0.5;
}

/// The tangent with which the piece leaves its first key.
Weights outgoing(const TcbKey& a, const TcbKey& b, const TcbKey& c)
{
    const double s = spacing(c.time_s - b.time_s, c.time_s - a.time_s) * (1 - b.tension);
    return {s * (1 + b.continuity) * (1 + b.bias), s * (1 - b.continuity) * (1 - b.bias)};
}

/// The tangent with which the piece reaches its last key.
Weights incoming(const TcbKey& b, const TcbKey& c, const TcbKey& d)
{
    const double s = spacing(c.time_s - b.time_s, d.time_s - b.time_s) * (1 - c.tension);
    return {s * (1 - c.continuity) * (1 + c.bias), s * (1 + c.continuity) * (1 - c.bias)};
}

glm::dquat quaternion(const TcbKey& key)
{
    return glm::dquat(key.value.w, key.value.x, key.value.y, key.value.z);
}

/// The vector part of the logarithm of a unit quaternion: axis * half the angle.
glm::dvec3 log_of(const glm::dquat& q)
{
    const glm::dvec3 v(q.x, q.y, q.z);
    const double angle = std::acos(std::clamp(q.w, -1.0, 1.0));
    const double sine = std::sin(angle);
    return std::abs(sine) < kSmallSine ? v : v * (angle / sine);
}

/// The inverse of log_of.
glm::dquat exp_of(const glm::dvec3& v)
{
    const double angle = glm::length(v);
    const double sine = std::sin(angle);
    const glm::dvec3 xyz = std::abs(sine) < kSmallSine ? v : v * (sine / angle);
    return glm::dquat(std::cos(angle), xyz.x, xyz.y, xyz.z);
}

/// From p to q along the great arc, without looking for the shorter one.
glm::dquat slerp(double u, const glm::dquat& p, const glm::dquat& q)
{
    const double angle = std::acos(std::clamp(glm::dot(p, q), -1.0, 1.0));
    const double sine = std::sin(angle);
    if (sine < kSmallSine) return p;
    return p * (std::sin((1 - u) * angle) / sine) + q * (std::sin(u * angle) / sine);
}

/// Normalised; the identity where there is nothing to normalise.
glm::dquat unit_of(const glm::dquat& q)
{
    const double length = std::sqrt(glm::dot(q, q));
    return length > 0 ? q * (1 / length) : glm::dquat(1, 0, 0, 0);
}

/// The sign that key `b` of a rotation has when each key is brought to the side of the one before
/// it, from the second on.
double sign_of(const std::vector<TcbKey>& keys, std::size_t b)
{
    double sign = 1;
    for (std::size_t k = 2; k <= b; ++k)
        if (glm::dot(keys[k - 1].value, keys[k].value) < 0) sign = -sign;
    return sign;
}

} // namespace

glm::dvec3 evaluate_vector(const std::vector<TcbKey>& keys, double time_s)
{
    if (keys.size() < 4) return glm::dvec3(keys[keys.size() > 1 ? 1 : 0].value);
    const auto [b, u] = find_piece(keys, time_s);
    const TcbKey& key_a = keys[b - 1];
    const TcbKey& key_b = keys[b];
    const TcbKey& key_c = keys[b + 1];
    const TcbKey& key_d = keys[b + 2];

    const Weights out = outgoing(key_a, key_b, key_c);
    const Weights in = incoming(key_b, key_c, key_d);
    const glm::dvec3 p(key_b.value);
    const glm::dvec3 step = glm::dvec3(key_c.value) - p;
    const glm::dvec3 leave = out.before * (p - glm::dvec3(key_a.value)) + out.after * step;
    const glm::dvec3 reach = in.before * step + in.after * glm::dvec3(key_d.value - key_c.value);

    // At the ends exactly the key, whatever its tangents.
    if (u == 0) return p;
    if (u == 1) return glm::dvec3(key_c.value);
    return p +
           u * (leave + u * (3.0 * step - 2.0 * leave - reach + u * (leave + reach - 2.0 * step)));
}

glm::dquat evaluate_rotation(const std::vector<TcbKey>& keys, double time_s)
{
    if (keys.size() < 4) return unit_of(quaternion(keys[keys.size() > 1 ? 1 : 0]));
    const auto [b, u] = find_piece(keys, time_s);
    const TcbKey& key_a = keys[b - 1];
    const TcbKey& key_b = keys[b];
    const TcbKey& key_c = keys[b + 1];
    const TcbKey& key_d = keys[b + 2];

    // Signs as BART's code leaves them: the first key and the one after the piece have not been
    // brought to the side of their neighbours when the tangents are made.
    const double sign_a = sign_of(keys, b - 1);
    const double sign_b = sign_of(keys, b);
    const double sign_c = sign_of(keys, b + 1);
    const glm::dquat qa = quaternion(key_a) * sign_a;
    const glm::dquat qb = quaternion(key_b) * sign_b;
    const glm::dquat qc = quaternion(key_c) * sign_c;
    const glm::dquat qd = quaternion(key_d);
    if (u == 0) return unit_of(qb);
    if (u == 1) return unit_of(qc);

    const Weights out = outgoing(key_a, key_b, key_c);
    const Weights in = incoming(key_b, key_c, key_d);
    const glm::dvec3 step = log_of(glm::conjugate(qb) * qc);
    const glm::dvec3 leave = out.after * step + out.before * log_of(glm::conjugate(qa) * qb);
    const glm::dvec3 reach = in.before * step + in.after * log_of(glm::conjugate(qc) * qd);
    const glm::dquat inner_b = qb * exp_of((leave - step) * 0.5);
    const glm::dquat inner_c = qc * exp_of((step - reach) * 0.5);
    return unit_of(slerp(2 * u * (1 - u), slerp(u, qb, qc), slerp(u, inner_b, inner_c)));
}

} // namespace firsthit
