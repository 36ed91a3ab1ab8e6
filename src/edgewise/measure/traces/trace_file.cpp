// SPDX-License-Identifier: MIT
#include "edgewise/measure/traces/trace_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iostream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace edgewise::measure {

namespace {

/// No access of a processor is larger; a larger one is a mistake in the file.
constexpr std::uint64_t most_bytes = 1 << 20;

/// What a line says, before anybody looked whether that can be.
struct Access {
    std::uint64_t address = 0, bytes = 0;
    enum class Label { read, write, fetch, modify } label = Label::read;
};

constexpr const char* din_wants =
    "'LABEL ADDRESS' with a label 0, 1 or 2, or 'r|w|i|m ADDRESS SIZE'; hexadecimal, sizes to 100000";
constexpr const char* lackey_wants =
    "'I  ADDRESS,SIZE' or ' L|S|M ADDRESS,SIZE', as lackey --trace-mem=yes --log-file=FILE writes";

void skip_blanks(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
}

/// Taken off the text's front; nothing: there is none, or it does not fit.
std::optional<std::uint64_t> take_number(std::string_view& text, int base) {
    if (base == 16 && (text.starts_with("0x") || text.starts_with("0X"))) text.remove_prefix(2);
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (error != std::errc() || end == text.data()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

bool is_sound(const Access& access) {
    return access.bytes > 0 && access.bytes <= most_bytes &&
           access.address + (access.bytes - 1) >= access.address;
}

std::optional<Access> din_access(std::string_view line) {
    using enum Access::Label;
    skip_blanks(line);
    constexpr std::string_view labels = "012rwim";
    const std::size_t which = line.empty() ? labels.npos : labels.find(line[0]);
    if (which == labels.npos || line.size() < 2 || (line[1] != ' ' && line[1] != '\t')) return std::nullopt;
    constexpr Access::Label meanings[] = {read, write, fetch, read, write, fetch, read};
    line.remove_prefix(1);
    skip_blanks(line);
    const auto address = take_number(line, 16);
    if (!address || (!line.empty() && line[0] != ' ' && line[0] != '\t')) return std::nullopt;
    if (which < 3) return Access{*address & ~std::uint64_t{3}, 4, meanings[which]};
    skip_blanks(line);
    const auto bytes = take_number(line, 16);
    if (!bytes || (!line.empty() && line[0] != ' ' && line[0] != '\t')) return std::nullopt;
    return Access{*address, *bytes, meanings[which]};
}

std::optional<Access> lackey_access(std::string_view line) {
    using enum Access::Label;
    constexpr std::string_view starts[] = {"I  ", " L ", " S ", " M "};
    constexpr Access::Label meanings[] = {fetch, read, write, modify};
    for (std::size_t i = 0; i < std::size(starts); ++i) {
        if (!line.starts_with(starts[i])) continue;
        line.remove_prefix(starts[i].size());
        const auto address = take_number(line, 16);
        if (!address || !line.starts_with(",")) return std::nullopt;
        line.remove_prefix(1);
        const auto bytes = take_number(line, 10);
        if (!bytes || !line.empty()) return std::nullopt;
        return Access{*address, *bytes, meanings[i]};
    }
    return std::nullopt;
}

[[noreturn]] void refuse(const std::string& file, std::uint64_t number, const char* wanted) {
    throw std::runtime_error(fmt::format("{}:{}: wants {}", file, number, wanted));
}

bool is_message(std::string_view line) { return line.starts_with("=="); }

bool next_line(std::istream& stream, std::string& line) {
    if (!std::getline(stream, line)) return false;
    if (line.ends_with('\r')) line.pop_back();
    return true;
}

void tell(const Access& access, const TraceReading& reading, TraceCounts& counts,
          const std::function<void(const FileAccess&)>& use) {
    using enum Access::Label;
    const auto bytes = static_cast<std::uint32_t>(access.bytes);
    if (access.label == fetch) {
        ++counts.fetches;
        if (reading.fetches) use({access.address, bytes, AccessKind::read});
        return;
    }
    if (access.label != write) {
        ++counts.reads;
        use({access.address, bytes, AccessKind::read});
    }
    if (access.label != read) {
        ++counts.writes;
        use({access.address, bytes, AccessKind::write});
    }
}

}  // namespace

TraceForm form_of(std::istream& stream, const std::string& file) {
    std::uint64_t number = 0;
    for (std::string line; next_line(stream, line);) {
        ++number;
        if (is_message(line)) continue;
        if (lackey_access(line)) return TraceForm::lackey;
        if (din_access(line)) return TraceForm::din;
        refuse(file, number,
               "a line of Dinero's din ('r 1f40 8', '0 1f40') or of Valgrind's lackey (' L 1f40,8')");
    }
    throw std::runtime_error(file + ": has no accesses, or cannot be read");
}

TraceCounts read_trace(std::istream& stream, const std::string& file, const TraceReading& reading,
                       const std::function<void(const FileAccess&)>& use) {
    const bool is_din = reading.form == TraceForm::din;
    TraceCounts counts;
    std::uint64_t number = 0;
    for (std::string line; next_line(stream, line);) {
        ++number;
        if (!is_din && is_message(line)) continue;
        const std::optional<Access> access = is_din ? din_access(line) : lackey_access(line);
        if (!access || !is_sound(*access)) refuse(file, number, is_din ? din_wants : lackey_wants);
        tell(*access, reading, counts, use);
    }
    if (stream.bad()) throw std::runtime_error(file + ": cannot be read to its end");
    return counts;
}

void DinWriter::on_access(const TracedAccess& access) {
    char line[64];
    const char* const end =
        fmt::format_to_n(line, sizeof line, "{} {:x} {:x}\n", access.kind == AccessKind::read ? 'r' : 'w',
                         access.address, access.bytes)
            .out;
    stream_->write(line, end - line);
}

}  // namespace edgewise::measure
