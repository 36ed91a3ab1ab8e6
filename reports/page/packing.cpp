// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/packing.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <cassert>
#include <sstream>
#include <stdexcept>

#include "edgewise/reports/page/files.hpp"

namespace edgewise::reports {

namespace {

constexpr int gzip_window = 15 + 16;  ///< the largest window, with gzip's header (zlib.h, deflateInit2)
constexpr int memory_level = 9;

int digit(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }

}  // namespace

std::string gzipped(std::string_view text) {
    z_stream stream{};
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip_window, memory_level,
                     Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::runtime_error("zlib cannot start: too little memory for the report's page");
    std::string packed(deflateBound(&stream, text.size()), '\0');
    std::string input(text);  // zlib's interface wants it writable
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = static_cast<uInt>(input.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    [[maybe_unused]] const int code = deflate(&stream, Z_FINISH);
    assert(code == Z_STREAM_END);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
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
        bytes += static_cast<char>(digit(hexadecimal[i]) * 16 + digit(hexadecimal[i + 1]));
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
        const auto script = read_file(directory / (name + ".min.js"));
        if (!script) return {};
        const auto licence = read_file(directory / (name + ".LICENSE"));
        const std::string text = (licence ? "/*! " + name + "\n" + *licence + "*/\n" : "") + *script;
        out += packed_element("bundle-" + name, without_source_map(text));
    }
    return out;
}

}  // namespace edgewise::reports
