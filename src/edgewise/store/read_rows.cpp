// SPDX-License-Identifier: MIT
#include "edgewise/store/read_rows.hpp"

#include <fmt/format.h>

namespace edgewise::store {

namespace {

measure::Timing read_timing(const sqlite::Statement& s, int column) {
    return {s.natural(column), s.natural(column + 2), s.real(column + 1), s.real(column + 3)};
}

}  // namespace

CellRow read_cell(const sqlite::Statement& s) {
    return {s.text(0),     s.text(1),     s.text(2),  s.text(3),    s.text(4),     s.text(5),
            s.text(6),     s.text(7),     s.text(8),  s.integer(9), s.integer(10), s.integer(11),
            s.natural(12), s.integer(13), s.text(14), s.text(15),   s.text(16)};
}

FigureRow read_figure(const sqlite::Statement& s) {
    return {{s.text(0), s.optional_real(1), s.text(2), s.text(3), s.text(4)}, s.text(5)};
}

measure::Round read_round(const sqlite::Statement& s) {
    return {static_cast<int>(s.integer(0)), read_timing(s, 1), read_timing(s, 5)};
}

std::optional<BuildRow> find_build(const sqlite::Database& database, const std::string& id) {
    sqlite::Statement s(database, fmt::format("select {} from build where id = ?", columns_of<BuildRow>));
    if (!s.bind(id).step()) return std::nullopt;
    return BuildRow{s.text(0), s.text(1), s.text(2), s.text(3), s.text(4), s.text(5)};
}

}  // namespace edgewise::store
