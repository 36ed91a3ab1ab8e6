// SPDX-License-Identifier: MIT
//
// What the page carries for its scripts, small: gzip (RFC 1952) by zlib, as base64 (RFC 4648), which browsers
// unpack by themselves (DecompressionStream). Among it are the three script bundles of the chart engine,
// fetched at set-up (cmake/charts.cmake).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace edgewise::reports {

/// Returns the compressed text; equal texts give equal bytes, since the header has no time.
[[nodiscard]] std::string gzipped(std::string_view text);
[[nodiscard]] std::string base64(std::string_view bytes);

/// A script element that no browser runs, "packed-ID", with the packed text in it.
[[nodiscard]] std::string packed_element(std::string_view id, std::string_view text);

/// "sha256-..." as a content security policy names a script, from its digest in hexadecimal.
[[nodiscard]] std::string script_hash(std::string_view hexadecimal);

[[nodiscard]] bool have_bundles(const std::filesystem::path& directory);
/// The three with their licences, packed as "bundle-NAME"; empty when one is missing.
[[nodiscard]] std::string bundle_elements(const std::filesystem::path& directory);

}  // namespace edgewise::reports
