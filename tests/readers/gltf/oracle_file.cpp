// oracle_file.cpp - the JSON and the numbers of a glTF file, read slowly.
#include "readers/gltf/oracle_file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

namespace firsthit {
namespace {

using nlohmann::json;

std::string read_file(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string from_base64(const std::string& text)
{
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned value = 0;
    int bits = 0;
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit == std::string::npos) continue;
        value = (value << 6 | unsigned(digit)) & 0xFFFFFF;
        bits += 6;
        if (bits >= 8) bytes += char(value >> (bits -= 8) & 255);
    }
    return bytes;
}

std::string from_percent(const std::string& text)
{
    std::string plain;
    for (std::size_t k = 0; k < text.size(); ++k)
        if (text[k] == '%' && k + 2 < text.size()) {
            plain += char(std::stoi(text.substr(k + 1, 2), nullptr, 16));
            k += 2;
        } else {
            plain += text[k];
        }
    return plain;
}

double component(const char* at, int type, bool normalized)
{
    const auto scaled = [&](double value, double most) {
        return normalized ? std::max(value / most, -1.0) : value;
    };
    switch (type) {
    case 5120: {
        std::int8_t v;
        std::memcpy(&v, at, 1);
        return scaled(v, 127);
    }
    case 5121: {
        std::uint8_t v;
        std::memcpy(&v, at, 1);
        return scaled(v, 255);
    }
    case 5122: {
        std::int16_t v;
        std::memcpy(&v, at, 2);
        return scaled(v, 32767);
    }
    case 5123: {
        std::uint16_t v;
        std::memcpy(&v, at, 2);
        return scaled(v, 65535);
    }
    case 5125: {
        std::uint32_t v;
        std::memcpy(&v, at, 4);
        return v;
    }
    default: {
        float v;
        std::memcpy(&v, at, 4);
        return double(v);
    }
    }
}

std::size_t size_of(int type)
{
    return type == 5120 || type == 5121 ? 1 : type == 5122 || type == 5123 ? 2 : 4;
}

} // namespace

std::optional<OracleFile> OracleFile::open(const std::filesystem::path& path)
{
    OracleFile file;
    std::string text = read_file(path), binary;
    if (text.substr(0, 4) == "glTF") {
        std::uint32_t length = 0;
        std::memcpy(&length, text.data() + 12, 4);
        if (text.size() > 28 + std::size_t(length)) binary = text.substr(28 + length);
        text = text.substr(20, length);
    }
    json& root = file.root = json::parse(text, nullptr, false);
    if (root.is_discarded()) return std::nullopt;
    for (const json& used : root.value("extensionsUsed", json::array()))
        for (const char* unknown :
            {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"})
            if (used == unknown) return std::nullopt;
    for (const json& buffer : root.value("buffers", json::array())) {
        if (!buffer.contains("uri")) {
            file.buffers.push_back(binary);
            continue;
        }
        const std::string uri = buffer["uri"];
        const std::size_t comma = uri.find(',');
        if (uri.rfind("data:", 0) == 0)
            file.buffers.push_back(from_base64(uri.substr(comma + 1)));
        else
            file.buffers.push_back(read_file(path.parent_path() / from_percent(uri)));
        if (file.buffers.back().size() < buffer["byteLength"].get<std::size_t>())
            return std::nullopt;
    }
    return file;
}

const char* OracleFile::view(std::size_t number, std::size_t& stride) const
{
    const json& v = root["bufferViews"][number];
    stride = v.value("byteStride", std::size_t(0));
    return buffers.at(v["buffer"].get<std::size_t>()).data() +
           v.value("byteOffset", std::size_t(0));
}

std::vector<std::vector<double>> OracleFile::accessor(std::size_t number) const
{
    static const std::map<std::string, std::size_t> kSizes = {{"SCALAR", 1}, {"VEC2", 2},
        {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
    const json& a = root["accessors"][number];
    const std::size_t n = kSizes.at(a["type"]);
    const int type = a["componentType"];
    const bool normalized = a.value("normalized", false);
    std::vector<std::vector<double>> values(
        a["count"].get<std::size_t>(), std::vector<double>(n, 0.0));
    const auto read = [&](const char* from, std::size_t stride, std::vector<double>& to) {
        (void)stride;
        for (std::size_t c = 0; c < n; ++c)
            to[c] = component(from + c * size_of(type), type, normalized);
    };
    if (a.contains("bufferView")) {
        std::size_t stride = 0;
        const char* from = view(a["bufferView"], stride) + a.value("byteOffset", std::size_t(0));
        if (stride == 0) stride = n * size_of(type);
        for (std::size_t k = 0; k < values.size(); ++k) read(from + k * stride, stride, values[k]);
    }
    if (a.contains("sparse")) {
        const json& s = a["sparse"];
        std::size_t unused = 0;
        const int index_type = s["indices"]["componentType"];
        const char* indices = view(s["indices"]["bufferView"], unused) +
                              s["indices"].value("byteOffset", std::size_t(0));
        const char* from = view(s["values"]["bufferView"], unused) +
                           s["values"].value("byteOffset", std::size_t(0));
        for (std::size_t k = 0; k < s["count"].get<std::size_t>(); ++k) {
            const auto at =
                std::size_t(component(indices + k * size_of(index_type), index_type, false));
            read(from + k * n * size_of(type), 0, values.at(at));
        }
    }
    return values;
}

} // namespace firsthit
