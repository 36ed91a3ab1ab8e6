// SPDX-License-Identifier: MIT
//
// The schema of the store: the only thing the report generator shares with the sweep. The version is in the
// file's `pragma user_version`, whose store it is in `pragma application_id`.
#pragma once

namespace edgewise::store {

inline constexpr int store_schema_version = 6;
/// The first version that this program opens. It had no column `run`: names of scenes said what measured a
/// row.
inline constexpr int store_schema_of_old_names = 5;
inline constexpr int store_application_id = 0x45644765;  ///< "EdGe", so that another program's file is known

/// Keys of meta: this and a table type's name hold the picture of that table, as SVG.
inline constexpr const char* drawing_key = "drawing ";

/// Likewise this and a layout's name: what it stores and what it derives, in one line.
inline constexpr const char* layout_key = "layout ";

/// Likewise this and a shape's name: the body whose heat is shown, and this and a cell's hash: how often its
/// scene reads each feature of it, both as JSON (sweep/cell_run.hpp).
inline constexpr const char *body_key = "body ", *heat_key = "heat ";

/// Likewise this and a scene file's name: its text, as JSON in one line; and this and its name: its path.
inline constexpr const char *scene_file_key = "scene ", *scene_path_key = "path of scene ";

/// Likewise this and the options of a sweep that filled the store: the build that ran it.
inline constexpr const char* command_key = "command ";

/// Likewise this and the options of a sweep: what it was to do, as JSON {"build", "cells", "done", "started",
/// "ended"}; times are UTC (ISO 8601), `ended` is null until it has done it all.
inline constexpr const char* run_key = "run ";

/// Keys of `meta` that name another library: "peer " and the cells' table type.
inline constexpr const char* peer_key = "peer ";

/// Which part of a campaign a store is, "3/8": the fourth of eight. The other key has the same value once
/// that part ran to its end.
inline constexpr const char *shard_key = "shard", *complete_key = "complete";

/// This and the name of a comparison, of a group of a sweep or of another run: the seconds that it took when
/// it last ran, by which parts are weighed and what is left of a sweep is estimated.
inline constexpr const char* took_key = "took ";

/// This and a study's name: the title, the text and the columns of its chapter as JSON (sweep/study.hpp).
inline constexpr const char* study_key = "study ";

/// schema.sql: creates what is not there.
extern const char* const store_schema;

}  // namespace edgewise::store
