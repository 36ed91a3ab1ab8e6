// SPDX-License-Identifier: MIT
#include "edgewise/sweep/axes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <optional>
#include <set>
#include <stdexcept>

#include "edgewise/input/count.hpp"
#include "edgewise/input/known_names.hpp"

namespace edgewise::sweep {

namespace {

[[noreturn]] void refuse(std::string_view entry, std::string_view wanted) {
    throw std::invalid_argument(fmt::format("axis '{}': {}", entry, wanted));
}

/// A number in [0, below).
double read_tolerance(std::string_view entry, std::string_view value, double below) {
    const auto number = input::parse_number(value);
    if (!number || *number < 0 || *number >= below)
        refuse(entry, fmt::format("wants a number from 0 to below {}", below));
    return *number;
}

constexpr std::string_view order_values = "given|bfs|spatial|rcm", sharing_values = "shared|per_instance",
                           allocator_values = "arena|jemalloc|libc", batch_values = "no|yes",
                           sub_distance_values = "cofactors|johnson", hardening_values = "on|off",
                           start_values = "kept|cold", build_values = "tool|default",
                           needs_values =
                               "nearer|within|verdict|distance|witnesses|features|depth|certificate";

template <class Value>
Value known(std::string_view entry, const std::optional<Value>& value, std::string_view values) {
    if (!value) refuse(entry, fmt::format("wants {}", values));
    return *value;
}

/// Returns true for the second of two values, "no|yes"; the first is the plain cell's.
bool is_second(std::string_view entry, std::string_view value, std::string_view values) {
    const std::size_t bar = values.find('|');
    if (value != values.substr(0, bar) && value != values.substr(bar + 1))
        refuse(entry, fmt::format("wants {}", values));
    return value == values.substr(bar + 1);
}

[[noreturn]] void refuse_unknown(std::string_view entry, std::string_view name) {
    std::vector<std::string> names, plain;
    for (const AxisInfo& axis : axes_known()) {
        plain.emplace_back(axis.name);
        names.push_back(fmt::format("{}={}", axis.name, axis.values));
    }
    refuse(entry, fmt::format("unknown{} known: {}", did_you_mean(name, plain), fmt::join(names, ", ")));
}

void take(Axes& axes, std::string_view entry) {
    const std::size_t equals = entry.find('=');
    const std::string_view name = entry.substr(0, equals);
    const std::string_view value = equals == entry.npos ? std::string_view{} : entry.substr(equals + 1);
    if (name == "contact_tolerance") {
        axes.query.contact_tolerance = read_tolerance(entry, value, 1e60);
    } else if (name == "gap_tolerance") {
        axes.query.gap_tolerance = read_tolerance(entry, value, 1);
    } else if (name == "order") {
        axes.tables.order = known(entry, vertex_order_from(value), order_values);
    } else if (name == "sharing") {
        axes.tables.sharing =
            is_second(entry, value, sharing_values) ? bench::Sharing::per_instance : bench::Sharing::shared;
    } else if (name == "allocator") {
        axes.tables.allocator = known(entry, bench::allocator_from(value), allocator_values);
    } else if (name == "batch") {
        axes.batch = is_second(entry, value, batch_values);
    } else if (name == "start") {
        axes.starts_cold = is_second(entry, value, start_values);
    } else if (name == "build") {
        axes.default_build = is_second(entry, value, build_values);
    } else if (name == "sub_distance") {
        axes.query.sub_distance = known(entry, sub_distance_solver_from(value), sub_distance_values);
    } else if (name == "hardening") {
        axes.query.hardened = !is_second(entry, value, hardening_values);
    } else if (name == "needs") {
        axes.set_needs(known(entry, needs_from(value), needs_values));
    } else if (name == "margin") {
        axes.margin = read_tolerance(entry, value, 1e60);
        if (axes.margin == 0) refuse(entry, "wants a number above 0: no distance is below 0");
    } else if (name == "radius") {
        axes.recorded_radii = value == "recorded";
        axes.radius = axes.recorded_radii ? 0 : read_tolerance(entry, value, 1e60);
    } else {
        refuse_unknown(entry, name);
    }
}

/// Returns true if this plus is a number's, as in "1e+3", and not between two entries.
bool is_of_number(std::string_view text, std::size_t plus) {
    return plus > 1 && (text[plus - 1] == 'e' || text[plus - 1] == 'E') &&
           (std::isdigit(static_cast<unsigned char>(text[plus - 2])) != 0 || text[plus - 2] == '.');
}

/// Refuses a margin that nothing asks about, and a question about one with a contact tolerance or in batches.
void check_margin(const Axes& axes, std::string_view text) {
    const bool asked = has_margin(axes.needs);
    if (!asked && text.find("margin=") != text.npos)
        refuse(text, "a margin goes with needs=nearer or needs=within: write both");
    const auto needs = fmt::format("needs={}", to_string(axes.needs));
    if (asked && axes.query.contact_tolerance != 0)
        refuse(text, needs + " asks for its margin, not for contact: leave contact_tolerance out");
    if (asked && axes.batch) refuse(text, needs + " asks one pair at a time: leave batch out");
}

/// Refuses a radius with needs, tolerances and batches that cells of rounded bodies do not support.
void check_radius(const Axes& axes, std::string_view text) {
    if (!axes.has_radius()) return;
    if (has_margin(axes.needs) || axes.needs > Needs::witnesses)
        refuse(text, "a radius goes with needs=verdict, distance and witnesses: choose one of these");
    if (axes.query.contact_tolerance != 0)
        refuse(text, "a radius is a tolerance of its own: leave contact_tolerance out");
    if (axes.batch) refuse(text, "bodies with a radius are asked one pair at a time: leave batch out");
}

/// Refuses an axis that such a loop does not know, because it was compiled alone.
void check_default_build(const Axes& axes, std::string_view text) {
    Axes others = axes;
    others.default_build = others.starts_cold = false;
    if (axes.default_build && !others.text().empty())
        refuse(text, fmt::format("build=default goes with start alone: leave {} out", others.text()));
}

}  // namespace

const std::vector<AxisInfo>& axes_known() {
    static const std::vector<AxisInfo> axes = {
        {"contact_tolerance", "LENGTH", "bodies as near as this or nearer are touching"},
        {"gap_tolerance", "RATIO", "GJK ends when the squared distance is known to this relative width"},
        {"order", order_values, "how a body's vertices are numbered, and so what lies side by side"},
        {"sharing", sharing_values, "one table per body, or one for each instance in the scene"},
        {"allocator", allocator_values, "where tables take their memory from"},
        {"batch", batch_values,
         "pairs in a row that differ are asked together, GJK's of small bodies side by side"},
        {"start", start_values,
         "a pair's queries start from its last answer, or each as if it were the first"},
        {"build", build_values,
         "default: query loops compiled with -O2 and no flag for a processor, as applications compile "
         "them; those of plan quick's contenders alone"},
        {"sub_distance", sub_distance_values,
         "how GJK solves its simplices: all cofactors at once, or Johnson's search; a batch's then one by one"},
        {"hardening", hardening_values,
         "off: V-Clip as published, its doubtful answers counted instead of recomputed; not to be timed"},
        {"needs", needs_values, "what the scene asks of every answer, and pays for"},
        {"margin", "RATIO",
         "the distance that needs=nearer and within ask about, divided by the larger body's extent"},
        {"radius", "RATIO|recorded",
         "bodies are rounded: with a radius around them, divided by each one's extent, or a recording's"},
    };
    return axes;
}

std::string Axes::text() const {
    std::vector<std::string> parts;
    if (query.contact_tolerance != 0)
        parts.push_back(fmt::format("contact_tolerance={}", query.contact_tolerance));
    if (query.gap_tolerance != 0) parts.push_back(fmt::format("gap_tolerance={}", query.gap_tolerance));
    const bench::TableOptions plain;
    if (tables.order != plain.order) parts.push_back(fmt::format("order={}", to_string(tables.order)));
    if (tables.sharing != plain.sharing)
        parts.push_back(tables.sharing == bench::Sharing::shared ? "sharing=shared" : "sharing=per_instance");
    if (tables.allocator != plain.allocator)
        parts.push_back(fmt::format("allocator={}", to_string(tables.allocator)));
    if (batch) parts.emplace_back("batch=yes");
    if (starts_cold) parts.emplace_back("start=cold");
    if (default_build) parts.emplace_back("build=default");
    if (query.sub_distance != SubDistanceSolver::cofactors)
        parts.push_back(fmt::format("sub_distance={}", to_string(query.sub_distance)));
    if (!query.hardened) parts.emplace_back("hardening=off");
    if (needs != Needs::witnesses) parts.push_back(fmt::format("needs={}", to_string(needs)));
    if (has_margin(needs)) parts.push_back(fmt::format("margin={}", margin));
    if (recorded_radii) parts.emplace_back("radius=recorded");
    if (radius != 0) parts.push_back(fmt::format("radius={}", radius));
    return fmt::format("{}", fmt::join(parts, "+"));
}

bool Axes::concerns(std::string_view algorithm) const {
    const bool of_gjk = query.gap_tolerance != 0 || query.sub_distance != SubDistanceSolver::cofactors;
    return tables != bench::TableOptions{} || needs != Needs::witnesses || query.contact_tolerance != 0 ||
           batch || starts_cold || default_build || has_radius() || (of_gjk && algorithm == "gjk") ||
           (!query.hardened && algorithm == "vclip");
}

Axes parse_axes(std::string_view text) {
    Axes axes;
    const std::string_view whole = text;
    std::set<std::string_view> names;
    while (!text.empty()) {
        const std::size_t plus = text.find('+');
        std::size_t end = plus;
        while (end != text.npos && is_of_number(text, end)) end = text.find('+', end + 1);
        const std::string_view entry = text.substr(0, end);
        if (!names.insert(entry.substr(0, entry.find('='))).second) refuse(whole, "an axis is given twice");
        if (end == text.size() - 1) refuse(whole, "an axis is missing after the plus");
        take(axes, entry);
        text.remove_prefix(end == text.npos ? text.size() : end + 1);
    }
    check_margin(axes, whole);
    check_radius(axes, whole);
    check_default_build(axes, whole);
    return axes;
}

}  // namespace edgewise::sweep
