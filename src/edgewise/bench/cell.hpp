// SPDX-License-Identifier: MIT
//
// A cell's identity: the hash that keys its rows. It covers everything that decides the answers (names, scene
// numbers, the bodies' bits, seed, query count), so that a store never mixes figures of different work.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/store/store.hpp"

namespace edgewise::bench {

struct TableType;

/// FNV-1a, 64 bits: no adversary here, only mix-ups.
class Fingerprint {
  public:
    Fingerprint& add(std::string_view text);
    Fingerprint& add(std::uint64_t number);
    Fingerprint& add(double number);
    Fingerprint& add(const Polyhedron& body);
    [[nodiscard]] std::string hex() const;
    [[nodiscard]] std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0xcbf29ce484222325;
};

/// Canonical JSON of a scene's numbers: keys sorted, shortest digits that read back the same.
[[nodiscard]] std::string parameters_json(const scene::SceneParameters& parameters);

/// Fills in what the table type and the body say: layout, precision and table; vertices, edges and faces.
void describe_cell(store::CellRow& cell, const TableType& type, const Polyhedron& body);

/// Fills in `hash` from the other members and the body.
void name_cell(store::CellRow& cell, const Polyhedron& body);

}  // namespace edgewise::bench
