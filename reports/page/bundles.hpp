// SPDX-License-Identifier: MIT
//
// The chart engine's three script bundles, fetched at set-up (cmake/charts.cmake) and inlined into the page.
#pragma once

#include <filesystem>
#include <string>

namespace edgewise::reports {

[[nodiscard]] bool have_bundles(const std::filesystem::path& directory);
/// The three as <script> elements with their licences, safe to stand in HTML; empty when one is missing.
[[nodiscard]] std::string bundle_scripts(const std::filesystem::path& directory);
/// Script text that may stand in a <script> element: no "</script", no "<!--", no sourceMappingURL line.
[[nodiscard]] std::string inline_script(const std::string& text);
/// JSON that may stand in a <script> element: every '<' becomes \u003c.
[[nodiscard]] std::string inline_json(const std::string& json);

}  // namespace edgewise::reports
