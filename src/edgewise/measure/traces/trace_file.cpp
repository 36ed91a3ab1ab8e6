// SPDX-License-Identifier: MIT
#include "edgewise/measure/traces/trace_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <istream>
#include <optional>
#include <stdexcept>
#include <utility>

#include "edgewise/input/known_names.hpp"

namespace edgewise::measure {
namespace {

/// No access of a processor is larger; a larger one is a mistake in the file.
constexpr std::uint64_t most_bytes = 1 << 20;

/// Content of a line, before it is checked.
struct Access {
    std::uint64_t address = 0, bytes = 0;
    enum class Label { read, write, fetch, modify } label = Label::read;
};

constexpr const char* din_wants =
    "'LABEL ADDRESS' with a label 0, 1 or 2, or 'r|w|i|m ADDRESS SIZE'; hexadecimal, sizes to 100000";
constexpr const char* lackey_wants =
    "'I  ADDRESS,SIZE' or ' L|S|M ADDRESS,SIZE', as lackey --trace-mem=yes --log-file=FILE writes";
constexpr const char* wants_no_commands =
    "an access: labels 3 and 4 (escapes), c (copy back) and v (invalidate) are commands to a cache, which this model "
    "does not have; delete such lines";
constexpr const char* wants_no_size =
    "no number after the address: labels 0, 1 and 2 have no sizes; write 'r|w|i ADDRESS SIZE', both hexadecimal";

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

bool at_word_end(std::string_view text) { return text.empty() || text[0] == ' ' || text[0] == '\t'; }

/// The label of one letter that the line begins with, taken off with the blanks behind it; 0 if there is
/// none.
char take_label(std::string_view& line) {
    skip_blanks(line);
    if (line.size() < 2 || at_word_end(line) || !at_word_end(line.substr(1))) return 0;
    const char label = line[0];
    line.remove_prefix(1);
    skip_blanks(line);
    return label;
}

/// A short number after the address of a traditional line, which can only be meant as a size. (A long one is
/// the word that was read, as other simulators write; Dinero leaves it out, too.)
bool has_size(std::string_view rest) {
    constexpr std::size_t most_digits = 3;
    skip_blanks(rest);
    const std::size_t before = rest.size();
    return take_number(rest, 16) && at_word_end(rest) && before - rest.size() <= most_digits;
}

bool has_letter(std::uint64_t address) {
    while (address > 0 && address % 16 < 10) address /= 16;
    return address > 0;
}

std::optional<Access> din_access(std::string_view line) {
    using enum Access::Label;
    constexpr std::string_view labels = "012rwim";
    constexpr Access::Label meanings[] = {read, write, fetch, read, write, fetch, read};
    const char label = take_label(line);
    const std::size_t which = label == 0 ? labels.npos : labels.find(label);
    const auto address = take_number(line, 16);
    if (which == labels.npos || !address || !at_word_end(line)) return std::nullopt;
    if (which < 3) {
        if (has_size(line)) return std::nullopt;
        return Access{*address & ~std::uint64_t{3}, 4, meanings[which]};
    }
    skip_blanks(line);
    const auto bytes = take_number(line, 16);
    if (!bytes || !at_word_end(line)) return std::nullopt;
    return Access{*address, *bytes, meanings[which]};
}

std::optional<Access> lackey_access(std::string_view line) {
    using enum Access::Label;
    constexpr std::string_view labels = "ILSM";
    constexpr Access::Label meanings[] = {fetch, read, write, modify};
    const char label = take_label(line);
    const std::size_t which = label == 0 ? labels.npos : labels.find(label);
    const auto address = take_number(line, 16);
    if (which == labels.npos || !address || !line.starts_with(",")) return std::nullopt;
    line.remove_prefix(1);
    const auto bytes = take_number(line, 10);
    skip_blanks(line);
    if (!bytes || !line.empty()) return std::nullopt;
    return Access{*address, *bytes, meanings[which]};
}

/// Returns the expected form of a din line that is not an access.
const char* wanted_of_din(std::string_view line) {
    const char label = take_label(line);
    if (!take_number(line, 16) || !at_word_end(line)) return din_wants;
    if (label == '3' || label == '4' || label == 'c' || label == 'v') return wants_no_commands;
    return label >= '0' && label <= '2' && has_size(line) ? wants_no_size : din_wants;
}

[[noreturn]] void refuse(const std::string& file, std::uint64_t number, std::string_view line,
                         std::string_view wanted) {
    throw std::runtime_error(fmt::format("{}:{}: '{}' wants {}", file, number, on_one_line(line), wanted));
}

/// Blank lines, comments, and what Valgrind says itself.
bool is_no_access(std::string_view line) {
    if (line.starts_with("==")) return true;
    skip_blanks(line);
    return line.empty() || line[0] == '#';
}

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

constexpr std::uint64_t line_bytes = 64;

}  // namespace

TraceForm form_of(std::istream& stream, const std::string& file) {
    std::uint64_t number = 0;
    for (std::string line; next_line(stream, line);) {
        ++number;
        if (is_no_access(line)) continue;
        if (lackey_access(line)) return TraceForm::lackey;
        if (din_access(line) || wanted_of_din(line) != din_wants) return TraceForm::din;
        refuse(file, number, line,
               "to be a line of Dinero's din ('r 1f40 8', '0 1f40') or of Valgrind's lackey ('I  1f40,3', "
               "' L 1f40,8')");
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
        if (is_no_access(line)) continue;
        const std::optional<Access> access = is_din ? din_access(line) : lackey_access(line);
        if (!access || !is_sound(*access))
            refuse(file, number, line, is_din ? wanted_of_din(line) : lackey_wants);
        counts.has_letters = counts.has_letters || has_letter(access->address);
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

DataProfile::DataProfile(std::span<const CacheMachine> machines) : machines_(machines) {
    for (const CacheMachine& machine : machines)
        for (const LevelGeometry& level : machine.caches.levels)
            events_.push_back(machine.name + "_" + level.name);
}

void DataProfile::start_object(const std::string& name, ComponentOf component_of) {
    object_ = name;
    component_of_ = std::move(component_of);
    models_.clear();
    for (const CacheMachine& machine : machines_) models_.emplace_back(machine.caches);
    last_query_.clear();
}

void DataProfile::start_steady() {
    std::erase_if(costs_, [&](const auto& cost) { return std::get<0>(cost.first) == object_; });
}

void DataProfile::on_access(const TracedAccess& access) {
    std::vector<std::uint64_t>& costs =
        costs_[{object_, std::string(component_of_(access)), access.step, access.field}];
    costs.resize(events_.size());
    ++costs[access.kind == AccessKind::read ? 0 : 1];
    if (access.side != TraceSide::scene)
        access.for_each_unit(line_bytes, [&](std::uint64_t line) {
            std::uint64_t& last = last_query_[2 * line + static_cast<std::uint64_t>(access.side)];
            costs[2] += std::exchange(last, query_) != query_;
        });
    std::size_t event = 3;
    for (CacheModel& model : models_) {
        for (std::size_t i = 0; i < model.counts().size(); ++i) costs[event + i] -= model.counts(i).misses;
        model.access(access.address, access.bytes, access.kind);
        for (std::size_t i = 0; i < model.counts().size(); ++i) costs[event++] += model.counts(i).misses;
    }
}

std::string DataProfile::text(std::span<const std::string_view> steps) const {
    std::string text =
        fmt::format("# callgrind format\nversion: 1\ncreator: edgewise\npositions: line\nevents: {}\n",
                    fmt::join(events_, " "));
    std::vector<std::uint64_t> totals(events_.size());
    std::string last;
    for (const auto& [place, costs] : costs_) {
        const auto& [object, component, step, field] = place;
        std::string function = fmt::format("\nob={}\nfl={}\nfn={}\n", object, component, steps[step]);
        if (function != last) text += function;
        last = std::move(function);
        text += fmt::format("{} {}\n", field + 1, fmt::join(costs, " "));
        for (std::size_t i = 0; i < costs.size(); ++i) totals[i] += costs[i];
    }
    return text + fmt::format("\ntotals: {}\n", fmt::join(totals, " "));
}

TraceCaches::TraceCaches(std::span<const CacheMachine> machines) {
    for (const CacheMachine& machine : machines) {
        std::vector<CacheModel>& models = machines_.emplace_back();
        models.emplace_back(machine.caches);
        if (!machine.tlbs.levels.empty()) models.emplace_back(machine.tlbs);
    }
}

void TraceCaches::access(const FileAccess& access) {
    ++(access.kind == AccessKind::read ? reads_ : writes_);
    for (std::vector<CacheModel>& models : machines_)
        for (CacheModel& model : models) model.access(access.address, access.bytes, access.kind);
    const std::uint64_t last = (access.address + (access.bytes - 1)) / line_bytes;
    for (std::uint64_t line = access.address / line_bytes; line <= last; ++line) {
        // Addresses of programs lie far apart, and reuse distances want small numbers.
        if (line != last_line_ || numbers_.empty())
            last_number_ = numbers_.try_emplace(line, numbers_.size()).first->second;
        last_line_ = line;
        reuse_.use(last_number_);
    }
}

std::vector<TraceCaches::Level> TraceCaches::levels(std::size_t machine) const {
    std::vector<Level> all;
    for (const CacheModel& model : machines_[machine])
        for (std::size_t i = 0; i < model.counts().size(); ++i)
            all.push_back({model.geometry().levels[i].name, model.counts(i)});
    return all;
}

std::uint64_t TraceCaches::knee_bytes() const { return knee(reuse_.curve(), reuse_.lines()) * line_bytes; }

std::uint64_t TraceCaches::misses(std::uint64_t bytes) const {
    return reuse_.curve().misses(bytes / line_bytes);
}

}  // namespace edgewise::measure
