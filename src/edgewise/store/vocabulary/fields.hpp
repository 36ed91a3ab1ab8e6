// SPDX-License-Identifier: MIT
//
// Figures about the fields of a table's records (studies/fields): which are read together, in which groups
// they should lie, and what became of that. `whose`: original (the table asked about), own_groups (its groups
// where they are chosen at run time), control (the same once more), predicted, advised (as it was built),
// beside (a table made by hand).
#pragma once

#include "edgewise/store/vocabulary/figure_info.hpp"

namespace edgewise::store::vocabulary {

// One figure a line.
// clang-format off
inline constexpr FigureInfo fields[] = {
    {"fields.bytes.{field}", "B", Population::none, Repeats::exactly, "of the field; fields are numbered in the order of their records"},
    {"fields.number.{field}", "1", Population::none, Repeats::exactly, "of the field, in the order of records"},
    {"fields.own_group.{field}", "1", Population::none, Repeats::exactly, "number of the record that the table keeps it in"},
    {"fields.advised_group.{field}", "1", Population::all, Repeats::exactly, "number of the record that it should be in, which reads fewest lines"},
    {"fields.query_part.{field}", "1", Population::all, Repeats::exactly, "part of the queries that read the field"},
    {"fields.step_part.{field}", "1", Population::all, Repeats::exactly, "part of the algorithm's steps that read a table which read the field"},
    {"fields.same_query.{field}.{other}", "1", Population::all, Repeats::exactly, "of the queries that read either field, the part that read both"},
    {"fields.same_step.{field}.{other}", "1", Population::all, Repeats::exactly, "likewise of steps"},
    {"fields.same_record.{field}.{other}", "1", Population::all, Repeats::exactly, "likewise of records in a step: 1 where a step that reads one of a record reads the other of it"},
    {"fields.lines.{whose}", "lines", Population::all, Repeats::exactly, "distinct lines of tables per query"},
    {"fields.unseen_lines.{whose}", "lines", Population::all, Repeats::exactly, "the same of the scene from another seed, whose queries the advice never saw"},
    {"fields.misses.{machine}.{level}.{whose}", "1", Population::all, Repeats::exactly, "modelled misses per query of a machine's level in the steady state"},
    {"fields.table_bytes.{whose}", "B", Population::none, Repeats::exactly, "of all tables"},
    {"fields.time_ratio.{whose}", "1", Population::all, Repeats::timed, "time over that of own_groups, or of original where no groups give it: median over interleaved rounds"},
    {"fields.time_ratio_low.{whose}", "1", Population::all, Repeats::timed, "its 95 % interval over the rounds of one process"},
    {"fields.time_ratio_high.{whose}", "1", Population::all, Repeats::timed, "likewise"},
    {"fields.lines_held", "1", Population::all, Repeats::exactly, "1: the built table reads as many lines as predicted, and fewer than the table asked about; else 0"},
    {"fields.time_held", "1", Population::all, Repeats::timed, "1: faster by more than the noise; 0: within the noise; -1: slower"},
};
// clang-format on

}  // namespace edgewise::store::vocabulary
