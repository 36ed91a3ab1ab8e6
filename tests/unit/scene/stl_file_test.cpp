// SPDX-License-Identifier: MIT
//
// STL texts and binaries: the same box from every form; counts, sizes, keywords and numbers that are wrong.
#include "edgewise/scene/mesh/mesh_parts.hpp"

#include <cctype>
#include <cstring>
#include <regex>

#include "mesh_texts.hpp"

namespace edgewise::scene {
namespace {

using namespace edgewise::testing;

using Parts = Result<std::vector<MeshPart>>;

const Vec3d half_sides(1, 0.5, 0.25);

std::string box_text() { return stl_text(box_points(half_sides), box_faces()); }

/// Returns a binary STL file of a box. The default header begins with "solid", which many exporters write.
std::string box_bytes(std::uint32_t announced = 12, const std::string& header = "solid box") {
    const auto points = box_points(half_sides);
    std::string bytes = header + std::string(80 - header.size(), header.empty() ? '\0' : ' ');
    bytes.append(reinterpret_cast<const char*>(&announced), 4);
    for (const auto& face : box_faces()) {
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            float numbers[12] = {};
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Vec3d& p = points[face[corner == 0 ? 0 : k + corner - 1]];
                for (int axis = 0; axis < 3; ++axis)
                    numbers[3 + 3 * corner + static_cast<std::size_t>(axis)] = static_cast<float>(p[axis]);
            }
            bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers).append(2, '\0');
        }
    }
    return bytes;
}

void expect_box(const std::string& bytes, bool in_single) {
    const Parts parts = stl_parts(bytes);
    ASSERT_TRUE(parts) << parts.error;
    ASSERT_EQ(parts->size(), 1U);
    EXPECT_EQ(parts->front().triangles.size(), 12U);
    EXPECT_EQ(parts->front().in_single, in_single);
    Vec3d low = parts->front().points[0], high = low;
    for (const Vec3d& point : parts->front().points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    EXPECT_EQ(low, Vec3d(-half_sides));
    EXPECT_EQ(high, half_sides);
}

void expect_stl_refused(const std::string& bytes, const std::string& said) {
    const Parts parts = stl_parts(bytes);
    EXPECT_FALSE(parts) << said;
    expect_said(parts.error, said);
}

std::string in_case(std::string text, int (*to)(int)) {
    for (char& c : text) c = static_cast<char>(to(static_cast<unsigned char>(c)));
    return text;
}

TEST(StlFile, ReadsEveryFormOfAText) {
    const std::string text = box_text();
    std::string title = text;
    for (std::size_t i = 0; i < title.size(); ++i)
        if (i == 0 || title[i - 1] == '\n' || title[i - 1] == ' ')
            title[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[i])));
    for (const std::string& form : {text, in_case(text, std::toupper), title}) {
        expect_box(form, false);
        for (const char* end : {"\r\n", "\r", "\n\n", " \t\n", "\n\t  "})
            expect_box(std::regex_replace(form, std::regex("\n"), end), false);
        expect_box("\xEF\xBB\xBF" + form, false);
        expect_box("\n  " + form, false);
        expect_box(std::regex_replace(form, std::regex("(\\d)\\n"), "$1 "), false);  // a facet on fewer lines
    }
    expect_box(std::regex_replace(text, std::regex("normal 0 0 0"), "normal nan -inf 0,5"), false);
    expect_box(std::regex_replace(text, std::regex("(end)?solid body"), "$1solid"), false);
    expect_box(box_bytes(), true);
    expect_box(box_bytes(12, ""), true);
}

TEST(StlFile, ReadsTextInDouble) {
    std::string text = stl_text({Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)}, {{0, 1, 2}});
    text.replace(text.find("vertex 1.000000"), 15, "vertex 5812345.6780000003");
    EXPECT_EQ(stl_parts(text)->front().points[1].x(), 5812345.6780000003);
}

TEST(StlFile, EverySolidIsAPart) {
    const Parts parts =
        stl_parts(box_text() + "solid empty\nendsolid empty\n" + in_case(box_text(), std::toupper));
    ASSERT_TRUE(parts) << parts.error;
    ASSERT_EQ(parts->size(), 2U);
    EXPECT_EQ((*parts)[0].name, "body");
    EXPECT_EQ((*parts)[1].name, "BODY");
}

TEST(StlFile, SaysTheSizeThatACountMakes) {
    const std::string whole = box_bytes();
    ASSERT_EQ(whole.size(), 684U);
    for (const char* header : {"", "solid box", "a box"}) {
        for (const std::uint32_t count : {0U, 1U, 11U, 13U, 1000U, 0xffffffU}) {
            const std::string wanted = std::to_string(84 + 50 * std::uint64_t{count});
            expect_stl_refused(box_bytes(count, header), ": announces " + std::to_string(count) +
                                                             " facets, which make " + wanted +
                                                             " bytes, and has 684");
        }
        for (std::size_t more = 1; more <= 120; ++more) {
            expect_stl_refused(box_bytes(12, header) + std::string(more, '\0'),
                               std::to_string(more) + " too many");
            expect_stl_refused(box_bytes(12, header).substr(0, 684 - more),
                               std::to_string(more) + " too few");
        }
    }
    for (std::size_t size = 1; size < 84; ++size)
        expect_stl_refused(whole.substr(0, size), size < 5 ? "bytes are neither a text" : ":");
    expect_stl_refused(box_bytes(0).substr(0, 84), "has no mesh inside");
}

TEST(StlFile, NamesTheFacetOfABinary) {
    for (const float wrong :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        std::string bytes = box_bytes();
        std::memcpy(bytes.data() + 84 + 6 * 50 + 12 + 4, &wrong, sizeof wrong);
        expect_stl_refused(bytes, ": facet 7: (");
    }
}

TEST(StlFile, NamesTheLineOfAText) {
    const std::string text = box_text();  // its first vertex is in line 4
    const std::string vertex =
        text.substr(text.find("vertex"), text.find('\n', text.find("vertex")) - text.find("vertex"));
    const std::pair<const char*, const char*> lines[] = {{"vertex 0,5 1 1", "decimal comma"},
                                                         {"vertex nan 1 1", "finite"},
                                                         {"vertex 1 inf 1", "finite"},
                                                         {"vertex 1 1 1e70", "beyond"},
                                                         {"vertex 1 1 x", "'x' is no number"},
                                                         {"vertex 1 1 1 1", "'1' where 'vertex' should be"},
                                                         {"point 1 1 1", "'point' where 'vertex' should be"}};
    for (const auto& [line, said] : lines) {
        std::string broken = text;
        broken.replace(broken.find(vertex), vertex.size(), line);
        for (const std::string& form : {broken, std::regex_replace(broken, std::regex("\n"), "\r\n")})
            expect_stl_refused(form, std::string(":4: "));
        expect_stl_refused(broken, said);
    }
}

/// Cut at any line or byte: never a part of the body.
TEST(StlFile, RefusesATextThatIsCutShort) {
    const std::string text = box_text();
    int refused = 0;
    for (std::size_t size = 7; size + 14 < text.size(); ++size, ++refused)
        ASSERT_FALSE(stl_parts(text.substr(0, size))) << size;
    EXPECT_GT(refused, 1000);
    expect_stl_refused(text.substr(0, text.find("endsolid")), "cut short");
    expect_stl_refused(text.substr(text.find("facet")), "neither a text that begins with 'solid'");
    expect_stl_refused(text + "facet normal 0 0 0\n", "'facet' where 'solid' should be");
}

// PLY and OFF files with counts that do not fit their rows, and rows with something else than numbers.

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
    for (const char* face : {"\n4 0 1 2 8\n", "\n4 0 1 2 -1\n", "\n4 0 1 2 x\n", "\n5 0 1 2 3\n",
                             "\nx 0 1 2 3\n", "\nx 0 1 2\n", "\nx 0\n"}) {
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
