// pose_oracle.cpp - evaluates a glTF file slowly.
#include "readers/gltf/pose_oracle.h"
#include "readers/gltf/oracle_file.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace firsthit {
namespace {

using nlohmann::json;
using Matrix = std::array<std::array<double, 4>, 4>; // [row][column]
using Vec3 = std::array<double, 3>;
using Vec4 = std::array<double, 4>;

Matrix identity()
{
    Matrix m{};
    for (std::size_t k = 0; k < 4; ++k) m[k][k] = 1;
    return m;
}

Matrix operator*(const Matrix& a, const Matrix& b)
{
    Matrix m{};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t k = 0; k < 4; ++k) m[r][c] += a[r][k] * b[k][c];
    return m;
}

Vec3 times(const Matrix& m, const Vec3& p)
{
    Vec3 q{};
    for (std::size_t r = 0; r < 3; ++r)
        q[r] = m[r][0] * p[0] + m[r][1] * p[1] + m[r][2] * p[2] + m[r][3];
    return q;
}

Vec4 unit(Vec4 q)
{
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (length == 0) return {0, 0, 0, 1};
    for (double& x : q) x /= length;
    return q;
}

Matrix rotation(const Vec4& q)
{
    const auto [x, y, z, w] = q;
    Matrix m = identity();
    m[0] = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0};
    m[1] = {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0};
    m[2] = {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0};
    return m;
}

} // namespace

struct PoseOracle::Data : OracleFile {
    explicit Data(OracleFile file) : OracleFile(std::move(file)) {}

    /// The value of an animated property, or nothing where the animation has no such channel.
    std::optional<std::vector<double>> animated(
        int animation, double t, std::size_t node, const std::string& path) const
    {
        if (animation < 0) return std::nullopt;
        const json& a = root["animations"][std::size_t(animation)];
        for (const json& channel : a["channels"]) {
            if (!channel["target"].contains("node")) continue;
            if (channel["target"]["node"] != node || channel["target"]["path"] != path) continue;
            const json& sampler = a["samplers"][channel["sampler"].get<std::size_t>()];
            return sample(sampler, t, path == "rotation");
        }
        return std::nullopt;
    }

    std::vector<double> sample(const json& sampler, double t, bool is_rotation) const
    {
        std::vector<double> times;
        for (const auto& k : accessor(sampler["input"])) times.push_back(k[0]);
        // One list of numbers a key, whatever the accessor's type.
        std::vector<double> flat;
        for (const auto& element : accessor(sampler["output"]))
            flat.insert(flat.end(), element.begin(), element.end());
        const std::string how = sampler.value("interpolation", "LINEAR");
        const std::size_t each = flat.size() / times.size();
        const auto key = [&](std::size_t k) {
            return std::vector<double>(flat.begin() + std::ptrdiff_t(k * each),
                flat.begin() + std::ptrdiff_t((k + 1) * each));
        };
        const std::size_t n = how == "CUBICSPLINE" ? each / 3 : each;
        const auto value_of = [&](std::size_t k) {
            const std::vector<double> all = key(k);
            if (how != "CUBICSPLINE") return all;
            return std::vector<double>(
                all.begin() + std::ptrdiff_t(n), all.begin() + std::ptrdiff_t(2 * n));
        };
        const auto rotation_of = [&](std::vector<double> q) {
            if (!is_rotation) return q;
            const Vec4 u = unit({q[0], q[1], q[2], q[3]});
            return std::vector<double>(u.begin(), u.end());
        };
        if (t <= times.front()) return rotation_of(value_of(0));
        if (t >= times.back()) return rotation_of(value_of(times.size() - 1));
        std::size_t k = 0;
        while (times[k + 1] <= t) ++k;
        const double span = times[k + 1] - times[k], u = (t - times[k]) / span;
        std::vector<double> result(n);
        if (how == "STEP") return rotation_of(value_of(k));
        if (how == "CUBICSPLINE") {
            const std::vector<double> a = key(k), b = key(k + 1);
            for (std::size_t c = 0; c < n; ++c)
                result[c] = (2 * u * u * u - 3 * u * u + 1) * a[n + c] +
                            span * (u * u * u - 2 * u * u + u) * a[2 * n + c] +
                            (-2 * u * u * u + 3 * u * u) * b[n + c] +
                            span * (u * u * u - u * u) * b[c];
            return rotation_of(result);
        }
        const std::vector<double> a = rotation_of(value_of(k)), b = rotation_of(value_of(k + 1));
        if (!is_rotation) {
            for (std::size_t c = 0; c < n; ++c) result[c] = a[c] + u * (b[c] - a[c]);
            return result;
        }
        double dot = 0;
        for (std::size_t c = 0; c < 4; ++c) dot += a[c] * b[c];
        const double sign = dot < 0 ? -1 : 1, angle = std::acos(std::min(1.0, std::abs(dot)));
        const double sine = std::sin(angle);
        for (std::size_t c = 0; c < 4; ++c)
            result[c] =
                sine < 1e-9
                    ? a[c]
                    : (std::sin((1 - u) * angle) * a[c] + sign * std::sin(u * angle) * b[c]) / sine;
        return rotation_of(result);
    }

    Matrix local(int animation, double t, std::size_t number) const
    {
        const json& node = root["nodes"][number];
        if (node.contains("matrix")) {
            Matrix m{};
            for (std::size_t c = 0; c < 4; ++c)
                for (std::size_t r = 0; r < 4; ++r)
                    m[r][c] = double(node["matrix"][4 * c + r].get<float>());
            return m;
        }
        const auto property = [&](const char* path, std::vector<double> other) {
            if (const auto moved = animated(animation, t, number, path)) return *moved;
            if (!node.contains(path)) return other;
            std::vector<double> values;
            for (const json& x : node[path]) values.push_back(double(x.get<float>()));
            return values;
        };
        const auto tr = property("translation", {0, 0, 0}), ro = property("rotation", {0, 0, 0, 1});
        const auto sc = property("scale", {1, 1, 1});
        Matrix move = identity(), scale = identity();
        for (std::size_t k = 0; k < 3; ++k) {
            move[k][3] = tr[k];
            scale[k][k] = sc[k];
        }
        return move * rotation(unit({ro[0], ro[1], ro[2], ro[3]})) * scale;
    }

    /// By looking for the parent of each node.
    Matrix global(int animation, double t, std::size_t number) const
    {
        for (std::size_t p = 0; p < root["nodes"].size(); ++p)
            if (root["nodes"][p].contains("children"))
                for (const json& child : root["nodes"][p]["children"])
                    if (child == number)
                        return global(animation, t, p) * local(animation, t, number);
        return local(animation, t, number);
    }

    std::vector<Vec3> vertices(
        int animation, double t, std::size_t number, const json& mesh, const json& primitive) const
    {
        const json& node = root["nodes"][number];
        std::vector<Vec3> points;
        for (const auto& p : accessor(primitive["attributes"]["POSITION"]))
            points.push_back({p[0], p[1], p[2]});
        if (primitive.contains("targets")) {
            std::vector<double> weights(primitive["targets"].size(), 0.0);
            const auto moved = animated(animation, t, number, "weights");
            const json rest =
                node.contains("weights") ? node["weights"] : mesh.value("weights", json::array());
            for (std::size_t w = 0; w < weights.size(); ++w)
                weights[w] = moved             ? (*moved)[w]
                             : w < rest.size() ? double(rest[w].get<float>())
                                               : 0.0;
            for (std::size_t w = 0; w < weights.size(); ++w) {
                if (!primitive["targets"][w].contains("POSITION")) continue;
                const auto delta = accessor(primitive["targets"][w]["POSITION"]);
                for (std::size_t v = 0; v < points.size(); ++v)
                    for (std::size_t c = 0; c < 3; ++c) points[v][c] += weights[w] * delta[v][c];
            }
        }
        if (!node.contains("skin") || !primitive["attributes"].contains("JOINTS_0")) {
            const Matrix m = global(animation, t, number);
            for (Vec3& p : points) p = times(m, p);
            return points;
        }
        const json& skin = root["skins"][node["skin"].get<std::size_t>()];
        std::vector<Matrix> joints;
        for (std::size_t j = 0; j < skin["joints"].size(); ++j) {
            Matrix bind = identity();
            if (skin.contains("inverseBindMatrices")) {
                const auto m = accessor(skin["inverseBindMatrices"])[j];
                for (std::size_t c = 0; c < 4; ++c)
                    for (std::size_t r = 0; r < 4; ++r) bind[r][c] = m[4 * c + r];
            }
            joints.push_back(global(animation, t, skin["joints"][j]) * bind);
        }
        std::vector<Vec3> sum(points.size(), Vec3{});
        std::vector<double> total(points.size(), 0.0);
        for (int set = 0; primitive["attributes"].contains("JOINTS_" + std::to_string(set));
             ++set) {
            const auto j = accessor(primitive["attributes"]["JOINTS_" + std::to_string(set)]);
            const auto w = accessor(primitive["attributes"]["WEIGHTS_" + std::to_string(set)]);
            for (std::size_t v = 0; v < points.size(); ++v)
                for (std::size_t k = 0; k < 4; ++k) {
                    if (w[v][k] == 0) continue;
                    const Vec3 p = times(joints.at(std::size_t(j[v][k])), points[v]);
                    for (std::size_t c = 0; c < 3; ++c) sum[v][c] += w[v][k] * p[c];
                    total[v] += w[v][k];
                }
        }
        for (std::size_t v = 0; v < points.size(); ++v) {
            if (total[v] == 0) continue; // stays where it is
            for (std::size_t c = 0; c < 3; ++c) points[v][c] = sum[v][c] / total[v];
        }
        return points;
    }

    void visit(int animation, double t, std::size_t number, OraclePose& pose) const
    {
        const json& node = root["nodes"][number];
        if (node.contains("mesh")) {
            const json& mesh = root["meshes"][node["mesh"].get<std::size_t>()];
            for (const json& primitive : mesh["primitives"]) {
                const int mode = primitive.value("mode", 4);
                if (mode < 4 || !primitive["attributes"].contains("POSITION")) continue;
                const std::vector<Vec3> points = vertices(animation, t, number, mesh, primitive);
                std::vector<std::size_t> order;
                if (primitive.contains("indices"))
                    for (const auto& i : accessor(primitive["indices"]))
                        order.push_back(std::size_t(i[0]));
                else
                    for (std::size_t v = 0; v < points.size(); ++v) order.push_back(v);
                const auto corner = [&](std::size_t k) {
                    const Vec3& p = points.at(order.at(k));
                    pose.corner.emplace_back(p[0], p[1], p[2]);
                };
                for (std::size_t i = 0; order.size() >= 3 && i + 2 < order.size();
                     i += mode == 4 ? 3 : 1)
                    if (mode == 4)
                        for (std::size_t k = 0; k < 3; ++k) corner(i + k);
                    else if (mode == 5)
                        for (const std::size_t k : {i, i + 1 + i % 2, i + 2 - i % 2}) corner(k);
                    else
                        for (const std::size_t k : {i + 1, i + 2, std::size_t(0)}) corner(k);
            }
        }
        if (node.contains("children"))
            for (const json& child : node["children"]) visit(animation, t, child, pose);
    }
};

PoseOracle::PoseOracle(std::unique_ptr<Data> data) : data_(std::move(data)) {}
PoseOracle::~PoseOracle() = default;
PoseOracle::PoseOracle(PoseOracle&&) noexcept = default;

std::optional<PoseOracle> PoseOracle::open(const std::filesystem::path& path)
{
    std::optional<OracleFile> file = OracleFile::open(path);
    if (!file) return std::nullopt;
    return PoseOracle(std::make_unique<Data>(std::move(*file)));
}

int PoseOracle::animations() const
{
    return int(data_->root.value("animations", json::array()).size());
}

std::pair<double, double> PoseOracle::range(int animation) const
{
    std::pair<double, double> range{1e30, -1e30};
    for (const json& sampler : data_->root["animations"][std::size_t(animation)]["samplers"])
        for (const auto& key : data_->accessor(sampler["input"])) {
            range.first = std::min(range.first, key[0]);
            range.second = std::max(range.second, key[0]);
        }
    return range;
}

OraclePose PoseOracle::pose(int animation, double time_s) const
{
    const json& root = data_->root;
    OraclePose pose;
    const json scenes = root.value("scenes", json::array());
    if (scenes.empty()) {
        // All nodes that are nobody's child.
        std::vector<bool> child(root.value("nodes", json::array()).size(), false);
        for (const json& node : root.value("nodes", json::array()))
            for (const json& c : node.value("children", json::array()))
                child[c.get<std::size_t>()] = true;
        for (std::size_t n = 0; n < child.size(); ++n)
            if (!child[n]) data_->visit(animation, time_s, n, pose);
        return pose;
    }
    for (const json& node :
        scenes[root.value("scene", std::size_t(0))].value("nodes", json::array()))
        data_->visit(animation, time_s, node, pose);
    return pose;
}

} // namespace firsthit
