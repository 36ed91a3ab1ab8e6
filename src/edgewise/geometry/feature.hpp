// SPDX-License-Identifier: MIT
//
// A feature of a body as the user names it: a kind and the *input* vertex indices it spans. This name
// survives hulls, duplicates and renumbering; inside, tables use opaque handles (table/contract.hpp).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace edgewise {

enum class FeatureKind : std::uint8_t { vertex, edge, face };

[[nodiscard]] constexpr std::string_view to_string(FeatureKind kind) {
    constexpr std::string_view names[] = {"vertex", "edge", "face"};
    return names[static_cast<int>(kind)];
}

struct NamedFeature {
    FeatureKind kind = FeatureKind::vertex;
    std::vector<std::uint32_t> vertices;  ///< indices into the vertex list the user gave
};

}  // namespace edgewise
