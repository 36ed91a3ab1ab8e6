// SPDX-License-Identifier: MIT
//
// The schema of the store, and the keys of its table `meta`. The version is in the file's `pragma
// user_version`, the program that owns the file in `pragma application_id`.
#pragma once

namespace edgewise::store {

inline constexpr int store_schema_version = 6;
/// The oldest version that this program opens. It had no column `run`: the name of a scene said which run
/// measured a row.
inline constexpr int store_schema_of_old_names = 5;
inline constexpr int store_application_id = 0x45644765;  ///< "EdGe"

// A key of `meta` is a text below. If the text ends with a blank, a name follows it.

/// Followed by a table type's name: the picture of that table, as SVG.
inline constexpr const char* drawing_key = "drawing ";

/// Followed by a layout's name: the data that it stores and the data that it derives, in one line.
inline constexpr const char* layout_key = "layout ";

/// body_key followed by a shape's name: the body; heat_key followed by a cell's hash: how often its scene
/// reads each feature of the body, and the steps of one query. Both as JSON (sweep/prepared_cell.hpp).
inline constexpr const char *body_key = "body ", *heat_key = "heat ";

/// Followed by a scene file's name: its text, as JSON in one line; and its path.
inline constexpr const char *scene_file_key = "scene ", *scene_path_key = "path of scene ";

/// Followed by the options of a sweep that filled the store: the build that ran it.
inline constexpr const char* command_key = "command ";

/// Followed by the options of a sweep: its progress, as JSON {"build", "cells", "done", "started", "ended"}.
/// Times are UTC (ISO 8601); `ended` is null until the sweep is complete.
inline constexpr const char* run_key = "run ";

/// Followed by the table type of another library's cells: the library.
inline constexpr const char* peer_key = "peer ";

/// shard_key: the shard of a sweep that the store has; "3/8" is the fourth of eight. complete_key: the same
/// value, once the shard is complete.
inline constexpr const char *shard_key = "shard", *complete_key = "complete";

/// Followed by the name of a comparison, of a group of a sweep or of another run: the seconds that it took
/// last time. They decide the size of shards and the estimate of the time left.
inline constexpr const char* took_key = "took ";

/// Followed by a build, a scene with its parameters and a shape (others_key_of): the largest share of the
/// processor that others took while a process timed these cells (measure::ShareOfOthers).
inline constexpr const char* others_key = "others ";

/// Followed by a build: nanoseconds of a load that each level of its machine's caches answers, then memory;
/// beyond those of the first level, as a JSON array.
inline constexpr const char* latencies_key = "latencies_ns ";

/// Followed by a study's name: the title, the text and the columns of its chapter, as JSON (sweep/study.hpp).
inline constexpr const char* study_key = "study ";

/// Text of schema.sql, which creates the tables that do not exist.
extern const char* const store_schema;

}  // namespace edgewise::store
