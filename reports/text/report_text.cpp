// SPDX-License-Identifier: MIT
//
// The texts themselves are generated.
#include "edgewise/reports/text/report_text.hpp"

#include <algorithm>
#include <cassert>

namespace edgewise::reports {

std::string_view report_text(std::string_view name) {
    const auto texts = embedded_texts();
    const auto found =
        std::ranges::find_if(texts, [&](const EmbeddedText& text) { return text.name == name; });
    assert(found != texts.end());
    return found == texts.end() ? std::string_view() : found->text;
}

std::string prose(std::string_view name) {
    std::string paragraph(report_text(name));
    while (!paragraph.empty() && paragraph.back() == '\n') paragraph.pop_back();
    std::replace(paragraph.begin(), paragraph.end(), '\n', ' ');
    return paragraph;
}

}  // namespace edgewise::reports
