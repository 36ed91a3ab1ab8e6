// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/html.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <new>
#include <regex>
#include <sstream>

#include "edgewise/input/file_text.hpp"
#include "edgewise/input/known_names.hpp"
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
    static const std::regex code("`([^`]*)`");
    for (const std::string& item : items)
        out += "<li>" + std::regex_replace(html_text(item), code, "<code>$1</code>") + "</li>\n";
    return out + "</ul>\n";
}

std::string html_select(const std::string& id, const std::string& label, const std::string& options) {
    return fmt::format("<label>{} <select id=\"{}\">{}</select></label>", label, id, options);
}

std::string html_option(const std::string& value, const std::string& text, bool chosen) {
    return fmt::format("<option value=\"{}\"{}>{}</option>", html_text(value), chosen ? " selected" : "",
                       html_text(text));
}

std::string gzipped(std::string_view text) {
    constexpr int gzip_window = 15 + 16;  // zlib.h: 16 more asks for a gzip header
    z_stream stream{};
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip_window, MAX_MEM_LEVEL,
                     Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::bad_alloc();
    std::string bytes(deflateBound(&stream, text.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));  // zlib only reads it
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(bytes.size());
    [[maybe_unused]] const int code = deflate(&stream, Z_FINISH);
    assert(code == Z_STREAM_END);
    bytes.resize(stream.total_out);
    deflateEnd(&stream);
    return bytes;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

std::string packed_element(std::string_view id, std::string_view text) {
    return fmt::format("<script type=\"text/plain\" id=\"packed-{}\">{}</script>\n", id,
                       base64(gzipped(text)));
}

std::string script_hash(std::string_view hexadecimal) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < hexadecimal.size(); i += 2)
        bytes += static_cast<char>(std::stoi(std::string(hexadecimal.substr(i, 2)), nullptr, 16));
    return "sha256-" + base64(bytes);
}

namespace {

/// vega first: the others look for it when they load.
const char* const bundle_names[] = {"vega", "vega-lite", "vega-embed"};

/// Developer tools would fetch what such a line names.
std::string without_source_map(const std::string& text) {
    std::istringstream lines(text);
    std::string kept, line;
    while (std::getline(lines, line))
        if (line.find("sourceMappingURL=") == std::string::npos || !line.starts_with("//"))
            (kept += line) += '\n';
    return kept;
}

}  // namespace

bool have_bundles(const std::filesystem::path& directory) {
    std::error_code ignored;
    for (const char* name : bundle_names)
        if (!std::filesystem::is_regular_file(directory / (std::string(name) + ".min.js"), ignored))
            return false;
    return true;
}

std::string bundle_elements(const std::filesystem::path& directory) {
    std::string out;
    for (const std::string name : bundle_names) {
        const auto script = input::read_file_text(directory / (name + ".min.js"));
        if (!script) return {};
        const auto licence = input::read_file_text(directory / (name + ".LICENSE"));
        const std::string text = (licence ? "/*! " + name + "\n" + *licence + "*/\n" : "") + *script;
        out += packed_element("bundle-" + name, without_source_map(text));
    }
    return out;
}

// No parser of XML: a scanner for the little that drawings are made of, tags with quoted attributes and text
// between them. Whatever is not that is refused, so what a browser would make of it need not be known.

namespace {

constexpr std::array<std::string_view, 9> plain_elements = {"svg",  "g",    "rect",   "text", "title",
                                                            "desc", "line", "circle", "tspan"};
constexpr std::array<std::string_view, 24> plain_attributes = {
    "x",       "y",           "x1",          "y1",        "x2",   "y2",     "cx",
    "cy",      "r",           "width",       "height",    "fill", "stroke", "stroke-width",
    "viewBox", "font-size",   "font-family", "transform", "role", "xmlns",  "text-anchor",
    "opacity", "font-weight", "fill-opacity"};

template <class Names>
bool is_among(const Names& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

bool is_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == ':'; }
bool is_name_or_digit(char c) { return is_name(c) || (c >= '0' && c <= '9'); }
bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

/// Returns true for an attribute that only the charts of the live page need.
bool is_dropped(std::string_view attribute) {
    constexpr std::array<std::string_view, 7> dropped = {
        "aria-",    "role=\"",        "xmlns:xlink=\"",   "stroke-miterlimit=\"",
        "class=\"", "font-family=\"", "pointer-events=\""};
    return std::ranges::any_of(dropped, [&](std::string_view name) { return attribute.starts_with(name); });
}

class SvgScanner {
  public:
    explicit SvgScanner(std::string_view rest) : rest_(rest) {}

    bool is_plain_picture() {
        skip_space();
        if (!rest_.starts_with("<svg")) return false;
        while (!rest_.empty()) {
            if (rest_.front() != '<') {
                rest_.remove_prefix(std::min(rest_.find('<'), rest_.size()));
            } else if (!is_plain_tag()) {
                return false;
            }
            // Text after the picture would become part of the page.
            if (open_ == 0) return skip_space(), rest_.empty();
        }
        return false;
    }

  private:
    void skip_space() {
        while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
    }
    std::string_view take_name() {
        std::size_t end = 0;
        while (end < rest_.size() && is_name_or_digit(rest_[end])) ++end;
        const std::string_view name = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return name;
    }
    bool take(std::string_view text) {
        if (!rest_.starts_with(text)) return false;
        rest_.remove_prefix(text.size());
        return true;
    }

    bool is_plain_tag() {
        if (take("</")) {
            --open_;
            return is_among(plain_elements, take_name()) && take(">") && open_ >= 0;
        }
        rest_.remove_prefix(1);
        if (!is_among(plain_elements, take_name())) return false;
        ++open_;
        for (skip_space(); !rest_.empty() && is_name(rest_.front()); skip_space())
            if (!is_plain_attribute()) return false;
        if (take("/>")) return --open_, true;
        return take(">");
    }

    bool is_plain_attribute() {
        if (!is_among(plain_attributes, take_name()) || !take("=\"")) return false;
        const std::size_t end = rest_.find('"');
        if (end == rest_.npos) return false;
        const std::string value = lower_case(rest_.substr(0, end));
        rest_.remove_prefix(end + 1);
        // url(...) would load, in letters of either case, and an entity could spell it.
        return value.find_first_of("<>&\\") == value.npos && value.find("url") == value.npos &&
               value.find("script") == value.npos;
    }

    std::string_view rest_;
    int open_ = 0;
};

}  // namespace

std::optional<std::string> safe_svg(std::string_view svg) {
    if (!SvgScanner(svg).is_plain_picture()) return std::nullopt;
    return std::string(svg);
}

std::string slim_svg(const std::string& svg, const std::string& label) {
    std::string slim;
    slim.reserve(svg.size());
    std::size_t decimals = 0;
    bool fraction = false, in_tag = false;
    for (std::size_t i = 0; i < svg.size(); ++i) {
        in_tag = svg[i] == '<' || (in_tag && svg[i] != '>');
        if (in_tag && svg[i] == ' ' && is_dropped(std::string_view(svg).substr(i + 1))) {
            const std::size_t end = svg.find('"', svg.find('"', i) + 1);
            if (end == svg.npos) break;
            i = end;
            continue;
        }
        const bool is_digit = svg[i] >= '0' && svg[i] <= '9';
        fraction = svg[i] == '.' || (fraction && is_digit);
        decimals = fraction && is_digit ? decimals + 1 : 0;
        if (!in_tag || decimals < 2) slim += svg[i];  // a tick of 0.25 stays one
    }
    const std::size_t start = slim.find("<svg ");
    if (start != slim.npos) slim.insert(start + 5, "role=\"img\" aria-label=\"" + html_text(label) + "\" ");
    return slim;
}

}  // namespace edgewise::reports
