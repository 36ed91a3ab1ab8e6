// SPDX-License-Identifier: MIT
//
// The chart engine's three script bundles, fetched at set-up (cmake/charts.cmake) and inlined into the page.
#pragma once

#include <filesystem>
#include <string>

namespace edgewise::reports {

[[nodiscard]] bool have_bundles(const std::filesystem::path& directory);
/// The three with their licences, packed (packing.hpp) as "bundle-NAME"; empty when one is missing.
[[nodiscard]] std::string bundle_elements(const std::filesystem::path& directory);

}  // namespace edgewise::reports
