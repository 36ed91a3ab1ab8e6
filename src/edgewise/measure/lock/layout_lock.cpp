// SPDX-License-Identifier: MIT
#include "edgewise/measure/lock/layout_lock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "edgewise/input/file_text.hpp"
#include "edgewise/input/json_text.hpp"

namespace edgewise::measure {

namespace {

using Json = nlohmann::ordered_json;

constexpr int form = 1;

void add_machine(const LayoutFacts& facts, const LayoutFacts::Machine& machine, LayoutLock& lock) {
    each_population(facts.lines, [&](std::string_view suffix, const auto& of) {
        const auto queries = static_cast<double>(of(facts.lines).queries);
        const MachineMisses& misses = of(machine.steady);
        for (const auto* levels : {&misses.caches, &misses.tlbs}) {
            for (const LevelMisses& level : *levels)
                lock.figures.emplace_back(
                    fmt::format("misses_per_query.{}.{}{}", machine.name, level.level, suffix),
                    static_cast<double>(level.misses.all()) / queries);
        }
        lock.figures.emplace_back(fmt::format("emptied_misses_per_query.{}.{}{}", machine.name,
                                              misses.caches.front().level, suffix),
                                  static_cast<double>(of(machine.emptied)) / queries);
    });
}

[[noreturn]] void refuse(const std::string& file, const std::string& field, const char* wanted) {
    throw std::runtime_error(fmt::format("{}: {}: wants {}", file, field, wanted));
}

/// An object's members, of one type.
template <class Value>
std::vector<std::pair<std::string, Value>> members(const Json& json, const std::string& field,
                                                   const std::string& file, const char* wanted,
                                                   bool (Json::*is_right)() const noexcept) {
    std::vector<std::pair<std::string, Value>> all;
    if (!json.contains(field) || !json[field].is_object()) refuse(file, field, "an object");
    for (const auto& [name, value] : json[field].items()) {
        if (!(value.*is_right)()) refuse(file, field + "." + name, wanted);
        all.emplace_back(name, value.template get<Value>());
    }
    return all;
}

std::string text_of(const std::string& value) { return value; }
/// The shortest digits that are this number again.
std::string text_of(double value) { return fmt::format("{}", value); }

template <class Value>
void compare(const std::vector<std::pair<std::string, Value>>& was,
             const std::vector<std::pair<std::string, Value>>& is, const std::string& prefix,
             std::vector<LockDifference>& found) {
    const auto find = [](const auto& members, const std::string& name) -> const Value* {
        const auto at = std::find_if(members.begin(), members.end(),
                                     [&](const auto& member) { return member.first == name; });
        return at == members.end() ? nullptr : &at->second;
    };
    for (const auto& [name, value] : was) {
        const Value* now = find(is, name);
        if (!now || *now != value)
            found.push_back({prefix + name, text_of(value), now ? text_of(*now) : "nothing"});
    }
    for (const auto& [name, value] : is)
        if (!find(was, name)) found.push_back({prefix + name, "nothing", text_of(value)});
}

}  // namespace

const std::string& LayoutLock::condition(std::string_view name, const std::string& file) const {
    for (const auto& [known, value] : of)
        if (known == name) return value;
    refuse(file, fmt::format("of.{}", name), "a text");
}

LayoutLock lock_of(const LayoutFacts& facts, std::vector<std::pair<std::string, std::string>> of) {
    LayoutLock lock{std::move(of), {}};
    std::uint64_t total = 0;
    for (const ComponentBytes& part : facts.bytes) {
        lock.figures.emplace_back("bytes." + part.component, static_cast<double>(part.bytes));
        total += part.bytes;
    }
    lock.figures.emplace_back("bytes", static_cast<double>(total));
    lock.figures.emplace_back("distinct_lines", static_cast<double>(facts.distinct_lines));
    each_population(facts.lines, [&](std::string_view suffix, const auto& population) {
        const LinesTouched& sums = population(facts.lines);
        const auto queries = static_cast<double>(sums.queries);
        const auto add = [&](const char* name, double value) {
            lock.figures.emplace_back(fmt::format("{}{}", name, suffix), value);
        };
        add("queries", queries);
        add("lines_per_query", static_cast<double>(sums.lines) / queries);
        add("knee_bytes", static_cast<double>(population(facts.knee_bytes).value_or(0)));
    });
    for (const LayoutFacts::Machine& machine : facts.machines) add_machine(facts, machine, lock);
    return lock;
}

std::string to_json(const LayoutLock& lock) {
    Json json = {{"edgewise_lock", form}, {"of", Json::object()}, {"figures", Json::object()}};
    for (const auto& [name, value] : lock.of) json["of"][name] = value;
    for (const auto& [name, value] : lock.figures) {
        const auto whole = static_cast<std::int64_t>(value);
        if (static_cast<double>(whole) == value)
            json["figures"][name] = whole;
        else
            json["figures"][name] = value;
    }
    return json.dump(2) + "\n";
}

LayoutLock parse_lock(const std::string& json, const std::string& file) {
    const auto read = input::parse_json<Json>(json);
    if (!read)
        throw std::runtime_error(
            fmt::format("{}: {}; wants a lock, as this program prints it", file, read.error));
    const Json& parsed = *read;
    if (!parsed.is_object()) refuse(file, "the file", "an object");
    if (const std::string unknown =
            input::unknown_member(parsed, "a lock", {"edgewise_lock", "of", "figures"});
        !unknown.empty())
        throw std::runtime_error(fmt::format("{}: {}", file, unknown));
    if (!parsed.contains("edgewise_lock") || parsed["edgewise_lock"] != form)
        refuse(file, "edgewise_lock", "1, the form that this program knows");
    return {members<std::string>(parsed, "of", file, "a text", &Json::is_string),
            members<double>(parsed, "figures", file, "a number", &Json::is_number)};
}

LayoutLock read_lock(const std::string& file) {
    const auto text = input::read_file_text(file);
    if (!text) throw std::runtime_error(text.error);
    return parse_lock(*text, file);
}

std::vector<LockDifference> differences(const LayoutLock& was, const LayoutLock& is) {
    std::vector<LockDifference> found;
    compare(was.of, is.of, "of.", found);
    compare(was.figures, is.figures, "", found);
    return found;
}

std::string to_text(const LockDifference& difference) {
    return fmt::format("{}: was {}, is {}", difference.member, difference.was, difference.is);
}

}  // namespace edgewise::measure
