// SPDX-License-Identifier: MIT
//
// Makes an adapter a module: describes its library, for the one function that the module exports.
#pragma once

#include "edgewise/peers/peer_bench_for.hpp"

namespace edgewise::peers {

template <class Library>
concept GivesVerdictsAlone = requires {
    Library::verdict_only;
};

/// Library: as for PeerBenchFor, with static members `name`, `precision`, `summary` and `cache`, and
/// `verdict_only` if it gives no distances. Its version and the flags are CMake's to say.
template <class Library>
inline constexpr PeerInfo info_of = {.name = Library::name,
                                     .precision = Library::precision,
                                     .library = EDGEWISE_PEER_LIBRARY,
                                     .summary = Library::summary,
                                     .cache = Library::cache,
                                     .flags = EDGEWISE_PEER_FLAGS,
                                     .verdict_only = GivesVerdictsAlone<Library>,
                                     .make = make_bench<Library>};

}  // namespace edgewise::peers
