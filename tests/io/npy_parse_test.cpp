// npy_parse_test.cpp - NumPy arrays of points, directions and ids: what is read and what is refused.
#include "io/npy_header.h"

#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/npy.h>
#include <firsthit/scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

template <class T>
std::string array_bytes(const std::vector<T>& values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// A format 1.0 file with this header text.
std::string file_of(const std::string& text, const std::string& data, char version = 1)
{
    std::string bytes = "\x93NUMPY";
    bytes += {version, 0, char(text.size() & 0xFF), char(text.size() >> 8)};
    if (version > 1) bytes += std::string(2, '\0');
    return bytes + text + data;
}

const std::string kTwoPoints = array_bytes<float>({1, 2, 3, 4, 5, 6});

TEST(NpyParse, ReadsFloatAndDoublePoints)
{
    const std::vector<glm::vec3> expected{{1, 2, 3}, {4, 5, 6}};
    EXPECT_EQ(parse_npy_points(npy_header("<f4", "(2, 3)") + kTwoPoints, "p"), expected);
    const std::string doubles = array_bytes<double>({1, 2, 3, 4, 5, 6});
    EXPECT_EQ(parse_npy_points(npy_header("<f8", "(2, 3)") + doubles, "p"), expected);
    const std::vector<glm::dvec3> precise{{0.1, 0.2, 0.3}};
    const std::string tenths = array_bytes<double>({0.1, 0.2, 0.3});
    EXPECT_EQ(parse_npy_vectors(npy_header("<f8", "(1, 3)") + tenths, "p"), precise);
    EXPECT_TRUE(parse_npy_points(npy_header("<f8", "(0, 3)"), "p").empty());
}

TEST(NpyParse, ReadsRays)
{
    const std::vector<std::array<float, 6>> expected{{1, 2, 3, 4, 5, 6}};
    const std::string doubles = array_bytes<double>({1, 2, 3, 4, 5, 6});
    EXPECT_EQ(parse_npy_rays(npy_header("<f8", "(1, 6)") + doubles, "r"), expected);
    EXPECT_EQ(
        message_of<FileError>([&] { parse_npy_rays(npy_header("<f8", "(2, 3)") + doubles, "r"); }),
        "r: the shape (2, 3) is not accepted, only (N, 6)");
}

TEST(NpyParse, ReadsFortranOrder)
{
    const std::vector<glm::vec3> expected{{1, 3, 5}, {2, 4, 6}};
    EXPECT_EQ(
        parse_npy_points(
            file_of("{'descr': '<f4', 'fortran_order': True, 'shape': (2, 3)}", kTwoPoints), "p"),
        expected);
}

template <class T>
std::string big_endian(const std::vector<T>& values)
{
    std::string bytes = array_bytes(values);
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(T))
        std::reverse(
            bytes.begin() + std::ptrdiff_t(at), bytes.begin() + std::ptrdiff_t(at + sizeof(T)));
    return bytes;
}

TEST(NpyParse, ReadsPointsOfEveryTypeInBothByteOrders)
{
    const std::vector<glm::vec3> expected{{1, 2, 3}};
    const auto check = [&](const std::string& type, auto one) {
        using T = decltype(one);
        const std::vector<T> values{T(1), T(2), T(3)};
        EXPECT_EQ(
            parse_npy_points(npy_header("<" + type, "(1, 3)") + array_bytes(values), "p"), expected)
            << type;
        EXPECT_EQ(
            parse_npy_points(npy_header(">" + type, "(1, 3)") + big_endian(values), "p"), expected)
            << type;
    };
    check("f4", float{});
    check("f8", double{});
    check("i1", std::int8_t{});
    check("i2", std::int16_t{});
    check("i4", std::int32_t{});
    check("i8", std::int64_t{});
    check("u1", std::uint8_t{});
    check("u2", std::uint16_t{});
    check("u4", std::uint32_t{});
    check("u8", std::uint64_t{});
    const std::string truths("\1\0\1", 3);
    EXPECT_EQ(parse_npy_points(npy_header("|b1", "(1, 3)") + truths, "p")[0], glm::vec3(1, 0, 1));
    EXPECT_EQ(parse_npy_points(npy_header("|i1", "(1, 3)") + "\xFF\x80\x7F", "p")[0],
        glm::vec3(-1, -128, 127));
}

TEST(NpyParse, ReadsFloatsOf16Bits)
{
    const auto points = parse_npy_vectors(
        npy_header("<f2", "(3, 3)") + array_bytes<std::uint16_t>({0x3C00, 0xC000, 0x3555, 0x7BFF,
                                          0x0001, 0x8400, 0x7C00, 0xFC00, 0x7E01}),
        "p");
    EXPECT_EQ(points[0], glm::dvec3(1, -2, 0.333251953125));
    EXPECT_EQ(points[1], glm::dvec3(65504, std::ldexp(1.0, -24), -std::ldexp(1.0, -14)));
    EXPECT_EQ(points[2].x, INFINITY);
    EXPECT_EQ(points[2].y, -INFINITY);
    EXPECT_TRUE(std::isnan(points[2].z));
}

TEST(NpyParse, RoundsWholeNumbersToFloatOnce)
{
    // By way of double this would be 2^24 times a power of two that is one unit lower.
    const std::int64_t value = (std::int64_t(1) << 60) + (std::int64_t(1) << 36) + 1;
    const auto points = parse_npy_points(
        npy_header("<i8", "(1, 3)") + array_bytes<std::int64_t>({value, value, value}), "p");
    EXPECT_EQ(points[0].x, std::ldexp(1.0f + std::ldexp(1.0f, -23), 60));
}

TEST(NpyParse, ReadsIdsOfEveryWidthAndByteOrder)
{
    const std::vector<std::uint32_t> expected{0, 7, kNoItem};
    const auto ids = [](const char* descr, const std::string& data) {
        return parse_npy_ids(npy_header(descr, "(3,)") + data, "ids");
    };
    EXPECT_EQ(ids("|i1", array_bytes<std::int8_t>({0, 7, -1})), expected);
    EXPECT_EQ(ids(">i2", big_endian<std::int16_t>({0, 7, -1})), expected);
    EXPECT_EQ(ids(">i8", big_endian<std::int64_t>({0, 7, -1})), expected);
    EXPECT_EQ(ids(">u4", big_endian<std::uint32_t>({0, 7, kNoItem})), expected);
    EXPECT_EQ(ids("|u1", std::string("\0\7\xFF", 3)), (std::vector<std::uint32_t>{0, 7, 255}));
    EXPECT_EQ(ids("<u2", array_bytes<std::uint16_t>({0, 7, 65535})),
        (std::vector<std::uint32_t>{0, 7, 65535}));
}

TEST(NpyParse, KeepsNumbersThatAreNotFinite)
{
    const std::string data = array_bytes<double>({NAN, 1e300, -INFINITY});
    const glm::vec3 p = parse_npy_points(npy_header("<f8", "(1, 3)") + data, "p")[0];
    EXPECT_TRUE(std::isnan(p.x));
    EXPECT_EQ(p.y, INFINITY);
    EXPECT_EQ(p.z, -INFINITY);
}

TEST(NpyParse, ReadsIdsOfFourTypes)
{
    const std::vector<std::uint32_t> expected{0, 7, kNoItem};
    const auto ids = [](const char* descr, const std::string& data) {
        return parse_npy_ids(npy_header(descr, "(3,)") + data, "ids");
    };
    EXPECT_EQ(ids("<u4", array_bytes<std::uint32_t>({0, 7, kNoItem})), expected);
    EXPECT_EQ(ids("<i4", array_bytes<std::int32_t>({0, 7, -1})), expected);
    EXPECT_EQ(ids("<i8", array_bytes<std::int64_t>({0, 7, -1})), expected);
    EXPECT_EQ(ids("<u8", array_bytes<std::uint64_t>({0, 7, kNoItem})), expected);
}

TEST(NpyParse, ReadsHeadersAsOtherWritersWriteThem)
{
    const std::vector<glm::vec3> expected{{1, 2, 3}, {4, 5, 6}};
    for (const char* text : {"{'descr':'<f4','fortran_order':False,'shape':(2,3)}",
             "{\"shape\": (2L, 3L), \"fortran_order\": False, \"descr\": \"<f4\", }   \n"})
        for (const char version : {char(1), char(2), char(3)})
            EXPECT_EQ(parse_npy_points(file_of(text, kTwoPoints, version), "p"), expected) << text;
    // One row is the same in both orders.
    EXPECT_EQ(parse_npy_points(file_of("{'descr': '<f4', 'fortran_order': True, 'shape': (1, 3)}",
                                   kTwoPoints.substr(0, 12)),
                  "p")
                  .size(),
        1u);
}

void expect_refused(const std::string& bytes, const std::string& why)
{
    const std::string message = message_of<FileError>([&] { parse_npy_points(bytes, "p.npy"); });
    EXPECT_NE(message.find(why), std::string::npos) << message;
    EXPECT_EQ(message.find("p.npy: "), 0u) << message;
}

TEST(NpyParse, SaysWhatIsWrongWithAFile)
{
    expect_refused("", "no NumPy file");
    expect_refused("ply\nformat ascii 1.0\n", "no NumPy file");
    expect_refused("\x93NUMPY", "ends within its header");
    expect_refused("\x93NUMPY\x02" + std::string(4, '\0'), "ends within its header");
    expect_refused(std::string("\x93NUMPY\x04\0\0\0", 10), "format 4.0 is not known");
    expect_refused(npy_header("<f4", "(2, 3)").substr(0, 60), "ends within its header");
    expect_refused(std::string("\x93NUMPY\x02\0\xFF\xFF\xFF\xFF", 12), "at most 10000");
}

TEST(NpyParse, SaysWhatIsWrongWithAnArray)
{
    expect_refused(
        npy_header("<c8", "(2, 3)") + kTwoPoints, "only float16, float32, float64, bool");
    expect_refused(npy_header("<f16", "(2, 3)") + kTwoPoints, "'<f16' is not accepted");
    expect_refused(npy_header("|f4", "(2, 3)") + kTwoPoints, "'|f4' is not accepted");
    expect_refused(npy_header("<M8[ns]", "(2, 3)") + kTwoPoints, "'<M8[ns]' is not accepted");
    expect_refused(npy_header("<U3", "(2, 3)") + kTwoPoints, "'<U3' is not accepted");
    expect_refused(npy_header("|O", "(2, 3)") + kTwoPoints, "'|O' is not accepted");
    expect_refused(npy_header("<4 ", "(2, 3)") + kTwoPoints, "is not accepted");
    for (const char* shape : {"(6,)", "(3, 2)", "(1, 2, 3)", "()"})
        expect_refused(npy_header("<f4", shape) + kTwoPoints, "only (N, 3)");
    expect_refused(npy_header("<f4", "(2, 3)") + kTwoPoints.substr(1), "does not fit");
    expect_refused(npy_header("<f4", "(2, 3)") + kTwoPoints + "x", "does not fit");
    expect_refused(npy_header("<f4", "(18446744073709551615, 3)") + kTwoPoints, "does not fit");
    expect_refused(npy_header("<f4", "(1537228672809129302, 3)") + kTwoPoints, "does not fit");
}

TEST(NpyParse, SaysWhatIsWrongWithAHeader)
{
    const std::string order = "'fortran_order': False, ", shape = "'shape': (2, 3)";
    for (const std::string text : {"", "{}", "{'descr': '<f4'}", "{'descr': '<f4', ", "[]",
             "{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (2,)}",
             "{'descr': '<f4', 'fortran_order': 0, 'shape': (2, 3)}",
             "{'descr': '<f4', 'descr': '<f4', 'fortran_order': False, 'shape': (2, 3)}",
             "{'descr': '<f4', 'fortran_order': False, 'shape': (2, -3)}",
             "{'descr': '<f4', 'fortran_order': False, 'shape': (99999999999999999999, 3)}",
             "{'descr': '<f4', 'fortran_order': False, 'shape': (2 3)}",
             "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3)} more",
             "{'descr': '<f4, 'fortran_order': False, 'shape': (2, 3)}",
             "{'descr': '<f\\x34', 'fortran_order': False, 'shape': (2, 3)}",
             "{'other': '<f4', 'fortran_order': False, 'shape': (2, 3)}"})
        expect_refused(file_of(text, kTwoPoints), "header is malformed");
}

TEST(NpyParse, NamesTheRowOfAnIdOutOfRange)
{
    const auto message = [](const char* descr, const std::string& data) {
        return message_of<FileError>(
            [&] { parse_npy_ids(npy_header(descr, "(2,)") + data, "ids.npy"); });
    };
    EXPECT_NE(
        message("<i8", array_bytes<std::int64_t>({0, -2})).find("row 1: -2"), std::string::npos);
    EXPECT_NE(message("<i8", array_bytes<std::int64_t>({1LL << 32, 0})).find("row 0: 4294967296"),
        std::string::npos);
    EXPECT_NE(message("<u8", array_bytes<std::uint64_t>({~0ull, 0})).find("row 0: 184"),
        std::string::npos);
    EXPECT_NE(message("<f4", array_bytes<float>({0, 1})).find("only bool, and integers"),
        std::string::npos);
}

TEST(NpyRead, RefusesWhatIsNoFile)
{
    EXPECT_NE(message_of<FileError>([] { read_npy_points("none/p.npy"); }).find("none/p.npy"),
        std::string::npos);
    EXPECT_NE(message_of<FileError>([] { read_npy_vectors("/dev/zero"); }).find("regular file"),
        std::string::npos);
    EXPECT_NE(
        message_of<FileError>([] { read_npy_ids("."); }).find("regular file"), std::string::npos);
}

TEST(NpyBytes, AreWrittenRowByRow)
{
    const TemporaryFolder folder;
    const std::string path = folder / "a.npy";
    const auto fill = [](std::size_t row, std::span<std::uint8_t> values) {
        for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::uint8_t(10 * row + k);
    };
    write_npy_bytes(path, {.rows = 2, .columns = 3}, fill);
    EXPECT_EQ(
        bytes_of(path), npy_header("|u1", "(2, 3)") + std::string("\x00\x01\x02\x0A\x0B\x0C", 6));
    write_npy_bytes(path, {.rows = 1, .columns = 2, .one_dimension = true}, fill);
    EXPECT_EQ(bytes_of(path), npy_header("|u1", "(2,)") + std::string("\x00\x01", 2));
    EXPECT_EQ(bytes_of(path).find('\n') % 64, 63u) << "the array is aligned";
}

TEST(NpyBytes, LeaveTheOldFileWhereARowFails)
{
    const TemporaryFolder folder;
    const std::string path = folder / "a.npy";
    write_npy_bytes(path, {.rows = 0, .columns = 3}, {});
    EXPECT_THROW(write_npy_bytes(path, {.rows = 1, .columns = 3},
                     [](std::size_t, std::span<std::uint8_t>) { throw FileError("no row"); }),
        FileError);
    EXPECT_EQ(std::filesystem::file_size(path), npy_header("|u1", "(0, 3)").size());
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.npy"});
}

} // namespace
} // namespace firsthit
