// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/html.hpp"

#include <fmt/core.h>

#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

std::string html_element(const std::string& name, const std::string& html, const std::string& style) {
    return fmt::format("<{0}{1}>{2}</{0}>\n", name, style.empty() ? "" : " class=\"" + style + "\"", html);
}

std::string html_paragraph(const std::string& text, const std::string& style) {
    return html_element("p", html_text(text), style);
}

std::string html_heading(const std::string& id, const std::string& text) {
    return fmt::format("<h2 id=\"{}\">{}</h2>\n", id, html_text(text));
}

std::string html_list(const std::vector<std::string>& items, const std::string& style) {
    if (items.empty()) return {};
    std::string out = "<ul class=\"" + style + "\">\n";
    for (const std::string& item : items) out += "<li>" + html_text(item) + "</li>\n";
    return out + "</ul>\n";
}

std::string html_select(const std::string& id, const std::string& label, const std::string& options) {
    return fmt::format("<label>{} <select id=\"{}\">{}</select></label>", label, id, options);
}

std::string html_option(const std::string& value, const std::string& text, bool chosen) {
    return fmt::format("<option value=\"{}\"{}>{}</option>", html_text(value), chosen ? " selected" : "",
                       html_text(text));
}

}  // namespace edgewise::reports
