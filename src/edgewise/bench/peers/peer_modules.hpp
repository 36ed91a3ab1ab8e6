// SPDX-License-Identifier: MIT
//
// The peers of this program: modules in a folder next to it, opened when they are first needed, each as a
// table type with one algorithm of its own name.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/peers/peer.hpp"

namespace edgewise::bench {

/// Descriptions that the modules give, by name and precision. If a module cannot be opened, throws
/// std::runtime_error with its name and the reason.
[[nodiscard]] std::span<const peers::PeerInfo* const> peers_found();

/// Table types of the peers, in that order. Each serves one algorithm, of its layout's name.
[[nodiscard]] std::span<const TableType> peer_types();

/// Algorithms of the peers: one for each name among them.
[[nodiscard]] std::span<const AlgorithmInfo> peer_algorithms();

/// Names as a user writes them: "bullet_epa2", "bullet_epa2_f64", "all". Throws std::invalid_argument that
/// lists the known names; where there are none at all, what to do.
[[nodiscard]] std::vector<const TableType*> select_peer_types(std::span<const std::string> names);

/// Folder of the modules, next to the program (peers_folder_name).
[[nodiscard]] std::filesystem::path peers_folder();

}  // namespace edgewise::bench
