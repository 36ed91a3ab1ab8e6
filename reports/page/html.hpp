// SPDX-License-Identifier: MIT
//
// The parts of the page: a few HTML elements, with escaped text; packed texts and scripts; and pictures that
// were found to be safe.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgewise::reports {

/// Returns an element around `html`, which is HTML already. `style`: a class of the style sheet, or empty.
[[nodiscard]] std::string html_element(const std::string& name, const std::string& html,
                                       const std::string& style = {});
/// A paragraph of text.
[[nodiscard]] std::string html_paragraph(const std::string& text, const std::string& style = {});
/// A heading with the name that links use.
[[nodiscard]] std::string html_heading(const std::string& id, const std::string& text);
[[nodiscard]] std::string html_list(const std::vector<std::string>& items, const std::string& style);

/// A choice with a name; `options` is HTML, of html_option.
[[nodiscard]] std::string html_select(const std::string& id, const std::string& label,
                                      const std::string& options);
[[nodiscard]] std::string html_option(const std::string& value, const std::string& text, bool chosen = false);

// What the page carries for its scripts, small: gzip (RFC 1952) by zlib, as base64 (RFC 4648), which browsers
// unpack by themselves (DecompressionStream). Among it are the three script bundles of the chart engine,
// fetched at set-up (cmake/charts.cmake).

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

// Pictures from a store, which may come from another person: they enter the page only if they hold
// nothing but shapes and text. Anything that could run, load or link is refused, and so is what is not
// understood.

/// The picture if every element and attribute of it is a plain one; null otherwise.
[[nodiscard]] std::optional<std::string> safe_svg(std::string_view svg);

/// Returns a chart's picture made smaller for the page: one label instead of one per mark, coordinates to a
/// tenth of a pixel.
[[nodiscard]] std::string slim_svg(const std::string& svg, const std::string& label);

}  // namespace edgewise::reports
