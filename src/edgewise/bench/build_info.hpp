// SPDX-License-Identifier: MIT
//
// What built this program and where it runs: the provenance in every store.
#pragma once

#include <span>
#include <string_view>

#include "edgewise/store/store.hpp"

namespace edgewise::bench {

/// Revision, compiler and flags are fixed at build time; the machine is read now.
[[nodiscard]] store::BuildRow this_build();

/// Revision of the sources, with a hash of what is not committed; a test program has none.
[[nodiscard]] const char* git_revision();

/// Version of the project, as "0.1.0".
[[nodiscard]] const char* project_version();

/// True of a layout or table type that this program has.
[[nodiscard]] bool is_built(std::string_view name);

/// Names of the manifest's layouts and table types, also of those that this program lacks.
[[nodiscard]] std::span<const std::string_view> manifest_layouts();

/// Folder where the set-up left the chart bundles.
[[nodiscard]] const char* charts_folder();

}  // namespace edgewise::bench
