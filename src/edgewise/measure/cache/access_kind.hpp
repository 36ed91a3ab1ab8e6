// SPDX-License-Identifier: MIT
//
// What an access does to memory.
#pragma once

#include <cstdint>

namespace edgewise::measure {

enum class AccessKind : std::uint8_t { read, write, modify };

}  // namespace edgewise::measure
