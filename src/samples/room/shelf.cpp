// shelf.cpp - the shelf at the wall and the books in it.
#include "samples/room/furniture.h"
#include "samples/room/textures/painted_texture.h"
#include "samples/room/swept.h"
#include "samples/room/textures/textures.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace firsthit {
namespace {

constexpr double kHalfWidth = 0.80, kHalfDepth = 0.145; // m
constexpr double kBoard = 0.012;                        // half of a board's thickness, m
constexpr int kBoards = 6;
constexpr double kStep = 0.375; // from board to board, m

/// The upper side of a board, from the lowest on.
double board_top(int board)
{
    return 0.10 + kStep * board;
}

Shape shelf_shape()
{
    Shape shelf;
    for (int board = 0; board < kBoards; ++board)
        add_rounded_box(shelf, {kHalfWidth - 0.025, kBoard, kHalfDepth - 0.002}, 0.003, 1,
            moved(0, board_top(board) - kBoard, 0));
    const double height = board_top(kBoards - 1) + 0.004;
    for (const double side : {-1.0, 1.0})
        add_rounded_box(shelf, {kBoard, height / 2, kHalfDepth}, 0.003, 1,
            moved(side * (kHalfWidth - kBoard), height / 2, 0));
    // A cross of thin slats in the place of a back.
    add_rounded_box(
        shelf, {kHalfWidth - 0.03, 0.02, 0.003}, 0.002, 1, moved(0, 0.55, -kHalfDepth + 0.004));
    add_rounded_box(
        shelf, {kHalfWidth - 0.03, 0.02, 0.003}, 0.002, 1, moved(0, 1.30, -kHalfDepth + 0.004));
    return shelf;
}

/// A book of a row, by the size that chance gives it.
struct Book {
    double thick = 0, tall = 0, deep = 0;
    int binding = 0;
};

Book book_of(int number)
{
    Book book;
    book.thick = 0.021 + 0.034 * chance(number, 91) * chance(number, 92);
    book.tall = 0.20 + 0.10 * chance(number, 93);
    book.deep = 0.14 + 0.07 * chance(number, 94);
    book.binding = static_cast<int>(chance(number, 95) * 0.999f * kBindings);
    return book;
}

/// A cover around pages, with its back towards z; texture coordinates of its binding.
void add_book(Shape& covers, std::vector<glm::vec2>& uv, Shape& pages, const Book& book,
    const glm::dmat4& place)
{
    constexpr double kCover = 0.0018;
    const std::size_t first = covers.position.size();
    const glm::dvec3 half(book.thick / 2, book.tall / 2, book.deep / 2);
    for (const double side : {-1.0, 1.0})
        add_box(
            covers, {kCover, half.y, half.z}, place * moved(side * (half.x - kCover), half.y, 0));
    // A round back.
    std::vector<TubePoint> back{
        {{0, 0.001, half.z - 0.004}, half.x}, {{0, 2 * half.y - 0.001, half.z - 0.004}, half.x}};
    add_tube(covers, back, {.sides = 6, .across = {0, 0, 1}}, place);
    const glm::dmat4 book_from_shape = glm::inverse(place);
    for (std::size_t k = first; k < covers.position.size(); ++k) {
        const glm::dvec3 p(book_from_shape * glm::dvec4(covers.position[k], 1));
        const double across = 0.5 + 0.44 * std::clamp(p.x / half.x, -1.0, 1.0);
        uv.emplace_back((book.binding + across) / kBindings,
            0.02 + 0.96 * std::clamp(p.y / book.tall, 0.0, 1.0));
    }
    add_box(pages, {half.x - 2 * kCover, half.y - 0.003, half.z - 0.005},
        place * moved(0, half.y, 0.0));
}

/// Books stand in rows; the last of a row leans, some rows are left free on their right.
void add_books(RoomScene& room, std::int32_t node)
{
    int number = 0;
    constexpr std::array<double, kBoards - 1> kFilled{0.62, 0.98, 0.80, 0.98, 0.55};
    for (int board = 0; board + 1 < kBoards; ++board) {
        Shape covers, pages;
        std::vector<glm::vec2> uv;
        double x = -kHalfWidth + 0.03;
        const double end = x + 2 * (kHalfWidth - 0.03) * kFilled[static_cast<std::size_t>(board)];
        for (;; ++number) {
            const Book book = book_of(number);
            if (x + book.thick > end) break;
            const double z = kHalfDepth - 0.02 - book.deep / 2 - 0.03 * chance(number, 96);
            add_book(
                covers, uv, pages, book, moved(x + book.thick / 2, board_top(board) + 0.0005, z));
            x += book.thick + 0.0012;
        }
        const Book leaning = book_of(number++);
        if (x + 0.12 < kHalfWidth - 0.03)
            add_book(covers, uv, pages, leaning,
                moved(x + 0.093, board_top(board) + 0.002, 0.0, {0, 0, 1}, 0.26) *
                    moved(-leaning.thick / 2, 0, 0));
        const std::int32_t row = room.add_node("books", node, glm::dmat4(1));
        room.add(row, room.materials().books, std::move(covers), std::move(uv));
        room.add(row, room.materials().paper, std::move(pages));
    }
}

/// A vase, a bowl and a globe where rows leave room.
void add_ornaments(RoomScene& room, std::int32_t node)
{
    const RoomMaterials& m = room.materials();
    Shape vase;
    add_lathe(vase,
        std::to_array<Outline>({{0, 0.01}, {0.030, 0.012}, {0.060, 0.06}, {0.062, 0.10},
            {0.045, 0.16}, {0.022, 0.20}, {0.020, 0.225}, {0.030, 0.245}, {0.033, 0.246},
            {0.0255, 0.225}, {0.026, 0.202}, {0.050, 0.162}, {0.068, 0.10}, {0.065, 0.056},
            {0.036, 0.006}, {0.034, 0.0}, {0.034, 0.0}, {0, 0.0}}),
        28);
    room.add(
        room.add_node("vase", node, moved(0.42, board_top(4), 0)), m.blue_glaze, std::move(vase));

    Shape globe;
    add_ellipsoid(globe, glm::dvec3(0.095), 28, moved(0, 0.17, 0));
    room.add(
        room.add_node("globe", node, moved(0.50, board_top(0), 0)), m.cushion, std::move(globe));
    Shape stand;
    add_lathe(stand,
        std::to_array<Outline>({{0, 0.070}, {0.010, 0.070}, {0.012, 0.05}, {0.016, 0.02},
            {0.060, 0.014}, {0.064, 0.006}, {0.062, 0.0}, {0.062, 0.0}, {0, 0.0}}),
        28);
    room.add(room.add_node("globe stand", node, moved(0.50, board_top(0), 0)), m.brass,
        std::move(stand));

    Shape pot;
    add_lathe(pot,
        std::to_array<Outline>({{0, 0.09}, {0.050, 0.09}, {0.052, 0.095}, {0.060, 0.095},
            {0.060, 0.080}, {0.055, 0.078}, {0.043, 0.0}, {0.043, 0.0}, {0, 0.0}}),
        28);
    room.add(room.add_node("pot", node, moved(0.56, board_top(2), 0.02)), m.clay, std::move(pot));
}

} // namespace

void add_shelf(RoomScene& room)
{
    const std::int32_t node =
        room.add_node("shelf", -1, moved(-0.75, 0, -kRoomHalf.z + kHalfDepth + 0.012));
    Shape shelf = shelf_shape();
    std::vector<glm::vec2> uv = box_mapping(shelf, 1.0);
    room.add(node, room.materials().walnut, std::move(shelf), std::move(uv));
    add_books(room, node);
    add_ornaments(room, node);
}

} // namespace firsthit
