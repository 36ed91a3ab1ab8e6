// SPDX-License-Identifier: MIT
//
// Which processor this is, from the text of /proc/cpuinfo. x86 and 64-bit Arm name things differently there;
// Arm's implementer, architecture, part and revision go by vendor, family, model and stepping here.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/machine/read_text.hpp"

namespace edgewise::measure {

struct Cpu {
    Expected<std::string> vendor;  ///< "GenuineIntel", "AuthenticAMD", or Arm's implementer: "0x41"
    Expected<std::string> name;
    Expected<std::int64_t> family, model, stepping;
    Expected<std::int64_t> cores;                ///< physical ones
    std::int64_t threads = 0;                    ///< logical processors the system runs
    std::vector<std::string> vector_extensions;  ///< those that change what code can be generated or run
    Expected<bool> hypervisor;                   ///< x86 only: the flag that shows a guest that it is one
};

[[nodiscard]] Cpu parse_cpu(std::string_view cpuinfo);

}  // namespace edgewise::measure
