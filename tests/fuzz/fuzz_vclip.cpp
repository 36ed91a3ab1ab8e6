// SPDX-License-Identifier: MIT
//
// The fuzz target of V-Clip.
#include "fuzz_pair.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return edgewise::fuzz_pair<edgewise::VClip>(data, size);
}
