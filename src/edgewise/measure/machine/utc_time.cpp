// SPDX-License-Identifier: MIT
#include "edgewise/measure/machine/utc_time.hpp"

#include <array>
#include <ctime>

namespace edgewise::measure {

std::string utc_time() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return {text.data(), length};
}

}  // namespace edgewise::measure
