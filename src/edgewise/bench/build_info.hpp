// SPDX-License-Identifier: MIT
//
// What built this program and where it runs: the provenance in every store.
#pragma once

#include "edgewise/store/store.hpp"

namespace edgewise::bench {

/// Revision, compiler and flags are fixed at build time; the machine is read now.
[[nodiscard]] store::BuildRow this_build();

/// Folder where the set-up left the chart bundles.
[[nodiscard]] const char* charts_folder();

}  // namespace edgewise::bench
