// SPDX-License-Identifier: MIT
//
// Pictures from a store, which may come from another person: they enter the page only if they hold
// nothing but shapes and text. Anything that could run, load or link is refused, and so is what is not
// understood.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace edgewise::reports {

/// The picture if every element and attribute of it is a plain one; null otherwise.
[[nodiscard]] std::optional<std::string> safe_svg(std::string_view svg);

/// Returns a chart's picture made smaller for the page: one label instead of one per mark, coordinates to a
/// tenth of a pixel.
[[nodiscard]] std::string slim_svg(const std::string& svg, const std::string& label);

}  // namespace edgewise::reports
