// SPDX-License-Identifier: MIT
//
// PLY and OFF files with counts that do not fit their rows, and rows with something else than numbers.
#include "edgewise/scene/mesh/mesh_parts.hpp"

#include <cstring>
#include <regex>

#include "mesh_texts.hpp"

namespace edgewise::scene {
namespace {

using namespace edgewise::testing;

std::string off_box() { return off_text(box_points(Vec3d(1, 1, 1)), box_faces()); }
std::string ply_box() { return ply_text(box_points(Vec3d(1, 1, 1)), box_faces()); }

std::string with_text(const std::string& text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return std::string(text).replace(at, what.size(), by);
}

template <class Number>
void put_binary(std::string& to, Number value, bool swapped) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    if (swapped) std::reverse(bytes, bytes + sizeof value);
    to.append(bytes, sizeof value);
}

/// Coordinates in double, a colour behind, faces with counts of two bytes.
std::string binary_box(bool big_endian, const std::string& vertices = "8", const std::string& faces = "6") {
    std::string text =
        std::string("ply\nformat ") + (big_endian ? "binary_big_endian" : "binary_little_endian") +
        " 1.0\ncomment by hand\nelement vertex " + vertices +
        "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nelement face " +
        faces + "\nproperty list ushort int vertex_indices\nend_header\n";
    for (const Vec3d& point : box_points(Vec3d(1, 1, 1))) {
        for (int axis = 0; axis < 3; ++axis) put_binary(text, point[axis], big_endian);
        text += '\xff';
    }
    for (const auto& face : box_faces()) {
        put_binary(text, static_cast<std::uint16_t>(face.size()), big_endian);
        for (const Index v : face) put_binary(text, static_cast<std::int32_t>(v), big_endian);
    }
    return text;
}

TEST(MeshRows, TakesWhatFits) {
    EXPECT_EQ(ply_rows_error(ply_box()), "");
    EXPECT_EQ(off_rows_error(off_box()), "");
    for (const bool big_endian : {false, true}) EXPECT_EQ(ply_rows_error(binary_box(big_endian)), "");
    for (const char* end : {"\r\n", "\n\n", " \n"}) {
        EXPECT_EQ(ply_rows_error(std::regex_replace(ply_box(), std::regex("\n"), end)), "");
        EXPECT_EQ(off_rows_error(std::regex_replace(off_box(), std::regex("\n"), end)), "");
    }
    EXPECT_EQ(off_rows_error(std::regex_replace(off_box(), std::regex("\n"), " # a note\n# another\n")), "");
    EXPECT_EQ(off_rows_error(with_text(off_box(), "OFF\n", "OFF ")), "");
    EXPECT_EQ(off_rows_error(std::regex_replace(with_text(off_box(), "OFF", "COFF"),
                                                std::regex("(\\.\\d+)\n"), "$1 1 0 0 1\n")),
              "");
    EXPECT_EQ(off_rows_error(with_text(off_box(), "4 0", "4 0") + "\n"), "");
}

TEST(MeshRows, RefusesCountsThatDoNotFit) {
    for (const char* vertices : {"7", "9", "6", "10"}) {
        EXPECT_NE(ply_rows_error(with_text(ply_box(), "vertex 8", std::string("vertex ") + vertices)), "")
            << vertices;
        EXPECT_NE(off_rows_error(with_text(off_box(), "8 6", std::string(vertices) + " 6")), "") << vertices;
        for (const bool big_endian : {false, true})
            EXPECT_NE(ply_rows_error(binary_box(big_endian, vertices)), "") << vertices;
    }
    for (const char* faces : {"5", "7", "0", "60"}) {
        EXPECT_NE(ply_rows_error(with_text(ply_box(), "face 6", std::string("face ") + faces)), "") << faces;
        EXPECT_NE(off_rows_error(with_text(off_box(), "8 6", std::string("8 ") + faces)), "") << faces;
        for (const bool big_endian : {false, true})
            EXPECT_NE(ply_rows_error(binary_box(big_endian, "8", faces)), "") << faces;
    }
    expect_said(off_rows_error(with_text(off_box(), "8 6", "8 7")), ": ends after 6 of 7 rows of 'faces'");
    expect_said(off_rows_error(with_text(off_box(), "8 6", "8 5")),
                ":16: more rows than the header announces");
    expect_said(off_rows_error(with_text(off_box(), "8 6", "9 6")),
                ":11: 5 numbers, and a row of 'vertices' has 3");
    expect_said(ply_rows_error(with_text(ply_box(), "vertex 8", "vertex 9")),
                ":18: 5 numbers, and a row of 'vertex'");
    const std::string whole = binary_box(false);
    for (std::size_t bytes = 1; bytes < 300; ++bytes) {
        expect_said(ply_rows_error(whole.substr(0, whole.size() - bytes)), ": ends after");
        expect_said(ply_rows_error(whole + std::string(bytes, 'x')),
                    ": has " + std::to_string(bytes) + " bytes more than its header announces");
    }
}

TEST(MeshRows, NamesTheLineOfANumber) {
    const std::string first = "-1.000000 -1.000000 -1.000000";
    const std::pair<const char*, const char*> rows[] = {
        {"0,5 1 1", "decimal comma"}, {"1 nan 1", "finite"}, {"1 1 -inf", "finite"},  {"1 1 1e70", "beyond"},
        {"1 x 1", "no number"},       {"1 1", "2 numbers"},  {"1 1 1 1", "4 numbers"}};
    for (const auto& [row, said] : rows) {
        const std::string ply = ply_rows_error(with_text(ply_box(), first, row));
        expect_said(ply, ":10: ");
        expect_said(ply, said);
        const std::string off = off_rows_error(with_text(off_box(), first, row));
        expect_said(off, ":3: ");
        expect_said(off, said);
    }
    for (const char* face :
         {"\n4 0 1 2 8\n", "\n4 0 1 2 -1\n", "\n4 0 1 2 x\n", "\n5 0 1 2 3\n", "\nx 0 1 2 3\n"}) {
        const std::string broken = std::regex_replace(off_box(), std::regex("\n4 .*\n"), face,
                                                      std::regex_constants::format_first_only);
        expect_said(off_rows_error(broken), ":11: ");
        const std::string ply = std::regex_replace(ply_box(), std::regex("\n4 .*\n"), face,
                                                   std::regex_constants::format_first_only);
        expect_said(ply_rows_error(ply), ":18: ");
    }
}

}  // namespace
}  // namespace edgewise::scene
