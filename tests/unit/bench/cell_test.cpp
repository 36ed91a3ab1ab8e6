// SPDX-License-Identifier: MIT
//
// Cell identities: the published FNV-1a, and a hash that every part of the work changes and nothing else.
#include "edgewise/bench/cell.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "edgewise/scene/shapes.hpp"

namespace edgewise::bench {
namespace {

/// FNV-1a by its definition, over bytes.
std::uint64_t fnv(const std::string& bytes) {
    std::uint64_t state = 14695981039346656037U;
    for (const char c : bytes) state = (state ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return state;
}

TEST(Fingerprint, IsFnv1aOverLittleEndianBytes) {
    EXPECT_EQ(Fingerprint().value(), fnv(""));
    EXPECT_EQ(fnv("foobar"), 0x85944171f73967e8U);  // published
    const std::string eight("\1\2\3\4\5\6\7\x08", 8);
    EXPECT_EQ(Fingerprint().add(std::uint64_t{0x0807060504030201}).value(), fnv(eight));
    EXPECT_EQ(Fingerprint().add("ab").value(), fnv(std::string("ab\2\0\0\0\0\0\0\0", 10)));
    EXPECT_EQ(Fingerprint().hex(), "cbf29ce484222325");
}

TEST(Fingerprint, TellsApartWhatLooksAlike) {
    std::set<std::uint64_t> seen;
    seen.insert(Fingerprint().add("ab").add("c").value());
    seen.insert(Fingerprint().add("a").add("bc").value());
    seen.insert(Fingerprint().add("abc").value());
    seen.insert(Fingerprint().add(0.0).value());
    seen.insert(Fingerprint().add(-0.0).value());
    seen.insert(Fingerprint().add(1.0).value());
    seen.insert(Fingerprint().add(std::uint64_t{1}).value());
    EXPECT_EQ(seen.size(), 7U);
}

TEST(Cell, ParametersAreCanonicalJson) {
    EXPECT_EQ(parameters_json({}), "{}");
    EXPECT_EQ(parameters_json({{"b", 0.1}, {"a", 2}}), R"({"a":2.0,"b":0.1})");
}

class CellName : public ::testing::Test {
  protected:
    CellName() : cube_(*scene::make_shape("cube8")), tetra_(*scene::make_shape("tetra4")) {
        row_.scene = "tumble";
        row_.scene_parameters = "{}";
        row_.shape = "cube8";
        row_.algorithm = "vclip";
        row_.table = "some_f64";
        row_.seed = 1;
        row_.queries = 100;
    }

    [[nodiscard]] std::string hash(const std::function<void(store::CellRow&)>& change,
                                   const Polyhedron& body) const {
        store::CellRow row = row_;
        change(row);
        name_cell(row, body);
        return row.hash;
    }

    Polyhedron cube_, tetra_;
    store::CellRow row_;
};

TEST_F(CellName, EveryPartOfTheWorkChangesIt) {
    std::set<std::string> seen;
    using Row = store::CellRow;
    const std::function<void(Row&)> same = [](Row&) {}, changes[] = {
                                                            same,
                                                            [](Row&r) { r.scene = "cold"; },
                                                            [](Row&r) { r.scene_parameters = "{\"a\":1.0}"; },
                                                            [](Row&r) { r.shape = "cube9"; },
                                                            [](Row&r) { r.algorithm = "gjk"; },
                                                            [](Row&r) { r.table = "some_f32"; },
                                                            [](Row&r) { r.axes = "gap_tolerance=0.01"; },
                                                            [](Row&r) { r.seed = 2; },
                                                            [](Row&r) { r.queries = 101; },
                                                        };
    for (const auto& change : changes) seen.insert(hash(change, cube_));
    seen.insert(hash(same, tetra_));
    Polyhedron nudged = cube_;
    nudged.vertices[3].y() = std::nextafter(nudged.vertices[3].y(), 9.0);
    seen.insert(hash(same, nudged));
    EXPECT_EQ(seen.size(), 11U);
}

TEST_F(CellName, WhatCameOutOfItDoesNot) {
    const auto with_result = [](store::CellRow& r) {
        r.status = store::CellStatus::verified;
        r.reason = "none";
        r.hash = "old";
    };
    EXPECT_EQ(hash(with_result, cube_), hash([](store::CellRow&) {}, cube_));
}

}  // namespace
}  // namespace edgewise::bench
