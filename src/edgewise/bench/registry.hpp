// SPDX-License-Identifier: MIT
//
// Every table type and every algorithm of this program, by name. The entries come from generated units, one a
// table type; the manifest is layouts/CMakeLists.txt.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/table/needs.hpp"
#include "edgewise/table/pieces.hpp"

namespace edgewise::bench {

struct TableType {
    std::string name;  ///< layout and precision: "aos_f64"
    std::string layout, precision;
    std::string stores, derives;          ///< one line each
    std::string variant_of;               ///< a layout that it hardly differs from; empty: none
    std::vector<std::string> algorithms;  ///< algorithms with a contract that the layout meets
    std::string storage;                  ///< of bodies: "double", "single", or a lossy layout's own
    bool single_storage = false;          ///< holds bodies in the range of single precision
    bool rounded_planes = false;          ///< stores planes rounder than what computes
    double eps = 0;                       ///< rounding step of what computes: 2^-52 or 2^-23
    bool is_peer = false;                 ///< another library (bench/peers); its errors are figures
    bool verdict_only = false;            ///< of a peer: it gives no distances
    std::function<std::unique_ptr<Runner>(std::string_view algorithm)> make_runner;
    std::function<Result<Polyhedron>(const Polyhedron&)> stored_body;  ///< what its tables hold of a body
    /// makes a table that runs no query: for its memory
    std::function<std::shared_ptr<const void>(const Polyhedron&, Parts)> make_table;
    std::function<Ledger(const Polyhedron&, Parts)> ledger;  ///< of a table built from a body it can store
    /// additional bytes of a table that keeps the user's indices of its vertices; empty for layouts that do
    /// not renumber them
    std::function<std::size_t(const Polyhedron&)> input_order_bytes;
    /// memory map of a table built now, in memory of the present source (table_memory.hpp)
    std::function<std::vector<MappedPiece>(const Polyhedron&, Parts)> memory_map;

    /// The parts that its algorithms need, all together.
    [[nodiscard]] Parts all_parts() const { return serves("vclip") ? Parts::features : Parts::support; }

    [[nodiscard]] bool serves(std::string_view algorithm) const {
        return std::find(algorithms.begin(), algorithms.end(), algorithm) != algorithms.end();
    }
};

struct AlgorithmInfo {
    std::string name, summary;
    Parts parts;
};

/// Table types of this program, in the manifest's order.
[[nodiscard]] std::span<const TableType> table_types();
/// By its name, as in "aos_f64"; null if this program does not have it, which a build may.
[[nodiscard]] const TableType* find_table_type(std::string_view name);
[[nodiscard]] std::span<const AlgorithmInfo> algorithms();
/// Throw std::invalid_argument for an unknown name; it lists the known types. Algorithms: a peer's too.
[[nodiscard]] const TableType& table_type_called(const std::string& name);
[[nodiscard]] const AlgorithmInfo& algorithm_called(std::string_view name);

/// Additional compiler flags of the query loops: " query loops: -march=native".
[[nodiscard]] const char* table_types_flags();

/// Folder next to this program with its peers' modules, which are compiled like its query loops.
[[nodiscard]] const char* peers_folder_name();

/// Names as a user writes them: "aos" (all its precisions), "aos_f64", "all". Throws std::invalid_argument
/// that lists the known names.
[[nodiscard]] std::vector<const TableType*> select_table_types(std::span<const std::string> names);
[[nodiscard]] std::vector<const TableType*> select_types(std::span<const TableType> from,
                                                         std::span<const std::string> names,
                                                         std::string_view what);
[[nodiscard]] std::vector<std::string> select_algorithms(std::span<const std::string> names);

}  // namespace edgewise::bench
