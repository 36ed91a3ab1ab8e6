// SPDX-License-Identifier: MIT
//
// Bytes of every layout, component by component, compared with sums computed by hand from V vertices, E edges
// and F faces of three bodies. Arrays of a line of 64 bytes or more start on a line: what the one before is
// short of it is padding. And all that a small body's table takes, the object included.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/aos_padded.hpp"
#include "edgewise/layouts/aosoa.hpp"
#include "edgewise/layouts/bepu.hpp"
#include "edgewise/layouts/hot_cold.hpp"
#include "edgewise/layouts/jitter2.hpp"
#include "edgewise/layouts/lazy.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/lean_relative.hpp"
#include "edgewise/layouts/line_per_vertex.hpp"
#include "edgewise/layouts/linked.hpp"
#include "edgewise/layouts/points_neighbours.hpp"
#include "edgewise/layouts/points_soa.hpp"
#include "edgewise/layouts/quantised.hpp"
#include "edgewise/layouts/quantised_outward.hpp"
#include "edgewise/layouts/quantised_relative.hpp"
#include "edgewise/layouts/ring.hpp"
#include "edgewise/layouts/ring_block.hpp"
#include "edgewise/layouts/shared_plane.hpp"
#include "edgewise/layouts/soa.hpp"
#include "edgewise/layouts/soa_stagger.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise {
namespace {

using Bytes = std::size_t;

constexpr Bytes to_line(Bytes bytes) { return (64 - bytes % 64) % 64; }

/// The terms of all expectations.
struct Counts {
    Bytes v, e, f;
    std::vector<Bytes> degrees = {};  ///< of the vertices

    /// What records of a vertex lack of whole lines.
    [[nodiscard]] Bytes short_of_lines(Bytes record, Bytes neighbour) const {
        Bytes sum = 0;
        for (const Bytes degree : degrees) sum += to_line(record + degree * neighbour);
        return sum;
    }
};

/// Before each array that takes a line, what is short of one.
Bytes between(const std::vector<Bytes>& arrays) {
    Bytes sum = 0, end = 0;
    for (const Bytes bytes : arrays) {
        const Bytes gap = bytes < 64 ? 0 : to_line(end);
        sum += gap;
        end += gap + bytes;
    }
    return sum;
}

/// The five arrays of rings: where a vertex's starts, neighbours, edges; where a face's starts, edges.
std::vector<Bytes> with_rings(std::vector<Bytes> arrays, const Counts& n) {
    for (const Bytes entries : {n.v + 1, 2 * n.e, 2 * n.e, n.f + 1, 2 * n.e}) arrays.push_back(4 * entries);
    return arrays;
}
Bytes ring_bytes(const Counts& n) { return 4 * (n.v + 1 + n.f + 1 + 6 * n.e); }

/// Bytes in the order of the ledger, without the user's indices: no table here keeps them.
struct Row {
    Bytes voronoi_planes, edge_geometry, vertex_coordinates, face_planes, topology, padding;
    [[nodiscard]] std::array<Bytes, component_names.size()> by_component() const {
        return {voronoi_planes, edge_geometry, vertex_coordinates, face_planes, topology, 0, padding};
    }
};

template <class Table, class Expect>
void expect_bytes(Expect expect) {
    for (const char* shape : {"tetra4", "cube8", "sphere386"}) {
        const auto body = stored_body<Table>(*scene::make_shape(shape));
        ASSERT_TRUE(body) << body.error;
        Counts counts{body->vertex_count(), body->edge_count(), body->face_count()};
        for (Index v = 0; v < body->vertex_count(); ++v)
            counts.degrees.push_back(body->ring_of_vertex(v).size());
        const Row expected = expect(counts);
        EXPECT_EQ(Table(*body, Parts::features).ledger().bytes, expected.by_component())
            << Table::name << " " << shape;
    }
}

TEST(LayoutBytes, OfAos) {
    expect_bytes<aos<f64>>([](const Counts& n) {
        const auto arrays = with_rings({24 * n.v, 176 * n.e, 32 * n.f}, n);
        return Row{128 * n.e, 32 * n.e, 24 * n.v, 32 * n.f, 16 * n.e + ring_bytes(n), between(arrays)};
    });
    expect_bytes<aos<f32>>([](const Counts& n) {
        const auto arrays = with_rings({12 * n.v, 96 * n.e, 16 * n.f}, n);
        return Row{64 * n.e, 16 * n.e, 12 * n.v, 16 * n.f, 16 * n.e + ring_bytes(n), between(arrays)};
    });
    expect_bytes<aos_padded<f64>>([](const Counts& n) {
        const auto arrays = with_rings({24 * n.v, 192 * n.e, 32 * n.f}, n);
        return Row{
            128 * n.e, 32 * n.e, 24 * n.v, 32 * n.f, 16 * n.e + ring_bytes(n), 16 * n.e + between(arrays)};
    });
    expect_bytes<aos_padded<f32>>([](const Counts& n) {
        const auto arrays = with_rings({12 * n.v, 96 * n.e, 16 * n.f}, n);
        return Row{64 * n.e, 16 * n.e, 12 * n.v, 16 * n.f, 16 * n.e + ring_bytes(n), between(arrays)};
    });
}

/// A table of aos, and a bit per edge in words of 64.
TEST(LayoutBytes, OfLazyAos) {
    expect_bytes<lazy<f64>>([](const Counts& n) {
        const auto arrays = with_rings({24 * n.v, 176 * n.e, 32 * n.f}, n);
        const Bytes bits = 8 * (n.e / 64 + 1);
        return Row{128 * n.e, 32 * n.e, 24 * n.v, 32 * n.f, 16 * n.e + ring_bytes(n) + bits, between(arrays)};
    });
}

TEST(LayoutBytes, OfSplitAndShortenedRecords) {
    expect_bytes<hot_cold<f64>>([](const Counts& n) {
        const auto arrays = with_rings({24 * n.v, 128 * n.e, 48 * n.e, 32 * n.f}, n);
        return Row{128 * n.e, 32 * n.e, 24 * n.v, 32 * n.f, 16 * n.e + ring_bytes(n), between(arrays)};
    });
    expect_bytes<shared_plane<f64>>([](const Counts& n) {  // four offsets; the direction
        const auto arrays = with_rings({24 * n.v, 72 * n.e, 32 * n.f}, n);
        return Row{32 * n.e, 24 * n.e, 24 * n.v, 32 * n.f, 16 * n.e + ring_bytes(n), between(arrays)};
    });
    expect_bytes<ring<f64>>([](const Counts& n) {  // ends and the places of four planes
        const auto arrays = with_rings({24 * n.v, 64 * n.e, 64 * n.e, 64 * n.e, 32 * n.f}, n);
        return Row{128 * n.e, 32 * n.e, 24 * n.v, 32 * n.f, 32 * n.e + ring_bytes(n), between(arrays)};
    });
}

std::vector<Bytes> scalar_arrays(const Counts& n) {
    std::vector<Bytes> arrays(3, 8 * n.v);
    arrays.insert(arrays.end(), 20, 8 * n.e);
    arrays.insert(arrays.end(), 4, 8 * n.f);
    arrays.insert(arrays.end(), 4, 4 * n.e);
    return arrays;
}

TEST(LayoutBytes, OfSoa) {
    expect_bytes<soa<f64>>([](const Counts& n) {
        const auto arrays = with_rings(scalar_arrays(n), n);
        return Row{128 * n.e, 32 * n.e, 24 * n.v, 32 * n.f, 16 * n.e + ring_bytes(n), between(arrays)};
    });
    expect_bytes<soa_stagger<f64>>([](const Counts& n) {  // a line more where an array has an even number
        Bytes gaps = 0;
        for (const Bytes bytes : scalar_arrays(n)) gaps += (bytes + 63) / 64 % 2 == 0 ? 64 : 0;
        const auto arrays = with_rings(scalar_arrays(n), n);
        return Row{128 * n.e, 32 * n.e, 24 * n.v, 32 * n.f, 16 * n.e + ring_bytes(n), gaps + between(arrays)};
    });
}

/// Lanes that the last block of 8 does not fill are padding: of 24 bytes per vertex, 176 per edge, 32 per
/// face.
TEST(LayoutBytes, OfAosoa) {
    expect_bytes<aosoa<f64>>([](const Counts& n) {
        const auto free = [](Bytes count) { return (8 - count % 8) % 8; };
        const Bytes lanes = 24 * free(n.v) + 176 * free(n.e) + 32 * free(n.f);
        return Row{128 * n.e,
                   32 * n.e,
                   24 * n.v,
                   32 * n.f,
                   16 * n.e + ring_bytes(n),
                   lanes + between(with_rings({}, n))};
    });
}

/// Pointers of 8 bytes: 8 in an edge, 2 x 3 in cones at its vertices, 2 x 2 in cones of its faces, 2 per
/// vertex and its index, 2 a face.
TEST(LayoutBytes, OfLinked) {
    expect_bytes<linked<f64>>([](const Counts& n) {
        return Row{128 * n.e, 32 * n.e, 24 * n.v, 32 * n.f, 144 * n.e + 20 * n.v + 16 * n.f, 4 * n.v};
    });
    expect_bytes<linked<f32>>([](const Counts& n) {
        return Row{64 * n.e, 16 * n.e, 12 * n.v, 16 * n.f, 144 * n.e + 20 * n.v + 16 * n.f, 0};
    });
}

Bytes width(Bytes largest) { return largest <= 0xff ? 1 : 2; }

/// Coordinates; then V + 1 offsets and 2 E neighbours, as narrow as they can be.
Row narrow(const Counts& n, Bytes of_vertex) {
    const Bytes offsets = (n.v + 1) * width(2 * n.e), neighbours = 2 * n.e * width(n.v - 1);
    return {0, 0, of_vertex * n.v, 0, offsets + neighbours, between({of_vertex * n.v, offsets, neighbours})};
}

TEST(LayoutBytes, OfDerivedTables) {
    expect_bytes<lean<f64>>([](const Counts& n) { return narrow(n, 24); });
    expect_bytes<lean<f32>>([](const Counts& n) { return narrow(n, 12); });
    expect_bytes<quantised<f64>>([](const Counts& n) { return narrow(n, 6); });
    expect_bytes<quantised<f32>>([](const Counts& n) { return narrow(n, 6); });
    expect_bytes<quantised_outward<f64>>([](const Counts& n) { return narrow(n, 6); });
}

/// Neighbours of a byte, whatever the number of vertices.
TEST(LayoutBytes, OfRelativeTables) {
    const auto relative = [](const Counts& n, Bytes of_vertex) {
        const Bytes offsets = (n.v + 1) * width(2 * n.e);
        const std::vector<Bytes> arrays = {of_vertex * n.v, 2 * n.e, offsets};
        return Row{0, 0, arrays[0], 0, offsets + 2 * n.e, between(arrays)};
    };
    expect_bytes<lean_relative<f32>>([&](const Counts& n) { return relative(n, 12); });
    expect_bytes<quantised_relative<f32>>([&](const Counts& n) { return relative(n, 6); });
}

TEST(LayoutBytes, OfPoints) {
    expect_bytes<points_soa<f64>>([](const Counts& n) {
        return Row{0, 0, 24 * n.v, 0, 0, between({8 * n.v, 8 * n.v, 8 * n.v})};
    });
    // A record on lines of its own: coordinates, index, number of neighbours; a neighbour's coordinates and
    // record.
    expect_bytes<points_neighbours<f64>>([](const Counts& n) {
        return Row{0, 0, 24 * n.v + 48 * n.e, 0, 8 * n.v + 8 * n.e, n.short_of_lines(32, 28)};
    });
    expect_bytes<points_neighbours<f32>>([](const Counts& n) {
        return Row{0, 0, 12 * n.v + 24 * n.e, 0, 8 * n.v + 8 * n.e, n.short_of_lines(20, 16)};
    });
}

/// The layouts of engines and papers, from their lists of fields.
TEST(LayoutBytes, OfTheField) {
    // A vertex of coordinates and two numbers of 16 bits, in double with 4 bytes of padding; neighbours
    // of 16.
    expect_bytes<jitter2<f32>>([](const Counts& n) {
        return Row{0, 0, 12 * n.v, 0, 4 * n.v + 4 * n.e, between({16 * n.v, 4 * n.e})};
    });
    expect_bytes<jitter2<f64>>([](const Counts& n) {
        return Row{0, 0, 24 * n.v, 0, 4 * n.v + 4 * n.e, 4 * n.v + between({32 * n.v, 4 * n.e})};
    });
    // Bundles of eight vertices and of eight planes; a corner of 4 bytes for either side of an edge, and
    // where each face's begin. Arrays of full bundles start on lines.
    expect_bytes<bepu<f32>>([](const Counts& n) {
        const auto up = [](Bytes count) { return (count + 7) / 8 * 8; };
        const Bytes free = 12 * (up(n.v) - n.v) + 16 * (up(n.f) - n.f);
        const Bytes gaps =
            n.f < 8 ? between({12 * up(n.v), 0, 0}) : between({12 * up(n.v), 16 * (n.f / 8 * 8)});
        const Bytes planes = 12 * up(n.v) + gaps + 16 * up(n.f);
        const Bytes before_corners = 8 * n.e < 64 ? 0 : to_line(planes);
        const Bytes corners = planes + before_corners + 8 * n.e;
        return Row{0,
                   0,
                   12 * n.v,
                   16 * n.f,
                   8 * n.e + 4 * n.f,
                   free + gaps + before_corners + (4 * n.f < 64 ? 0 : to_line(corners))};
    });
    // A line each; all degrees here fit.
    expect_bytes<line_per_vertex<f64>>(
        [](const Counts& n) { return Row{0, 0, 24 * n.v, 0, 4 * n.v + 8 * n.e, 36 * n.v - 8 * n.e}; });
    // Coordinates; then a block of 128 bytes each, with the end of the ring where eight neighbours leave
    // room.
    expect_bytes<ring_block<f32>>([](const Counts& n) {
        const auto full = static_cast<Bytes>(std::count(n.degrees.begin(), n.degrees.end(), Bytes{8}));
        const Bytes topology = 8 * n.e + 4 * (n.v - full), coordinates = 12 * n.v + 24 * n.e;
        return Row{0, 0, coordinates, 0, topology, to_line(12 * n.v) + 140 * n.v - coordinates - topology};
    });
}

/// With the object, at four and at eight vertices: boxes with a table each are the commonest scene there is.
TEST(LayoutBytes, OfASmallTableAreItsPayloadAndOneLine) {
    const auto all_in = []<class Table>(const Table* /*unused*/, const char* shape) {
        const Table table(*scene::make_shape(shape), Parts::features);
        const Bytes object = sizeof(Table);
        EXPECT_LE(object, 64U) << Table::name;
        const Bytes sum = object + table.ledger().total();
        std::printf("%s of %s: %zu bytes, including object %zu and padding %zu\n", Table::name.data(), shape,
                    sum, object, table.ledger()[Component::padding]);
        return sum;
    };
    for (const char* shape : {"cube8", "sphere8"}) {
        EXPECT_LE(all_in(static_cast<const lean<f64>*>(nullptr), shape), 320U);
        EXPECT_LE(all_in(static_cast<const lean<f32>*>(nullptr), shape), 220U);
        EXPECT_LE(all_in(static_cast<const points_soa<f64>*>(nullptr), shape), 256U);
        EXPECT_LE(all_in(static_cast<const points_soa<f32>*>(nullptr), shape), 160U);
    }
    EXPECT_LE(all_in(static_cast<const lean<f64>*>(nullptr), "tetra4"), 180U);
    EXPECT_LE(all_in(static_cast<const points_soa<f64>*>(nullptr), "tetra4"), 160U);
}

}  // namespace
}  // namespace edgewise
