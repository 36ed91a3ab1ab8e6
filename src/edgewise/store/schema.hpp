// SPDX-License-Identifier: MIT
//
// The schema of the store: the only thing the report generator shares with the sweep. The version is in the
// file's `pragma user_version`, whose store it is in `pragma application_id`.
#pragma once

namespace edgewise::store {

inline constexpr int store_schema_version = 2;
inline constexpr int store_application_id = 0x45644765;  ///< "EdGe", so that another program's file is known

/// Keys of meta: this and a table type's name hold the picture of that table, as SVG.
inline constexpr const char* drawing_key = "drawing ";

/// Likewise this and a scene file's name: its text, as JSON in one line.
inline constexpr const char* scene_file_key = "scene ";

inline constexpr const char* store_schema = R"sql(
create table if not exists meta(key text primary key, value text not null) without rowid;

create table if not exists build(
    id text primary key,
    git_revision text not null, compiler text not null, flags text not null, build_type text not null,
    machine_json text not null) without rowid;

create table if not exists cell(
    build text not null references build(id), hash text not null,
    scene text not null, scene_parameters text not null,
    shape text not null, shape_source text not null,
    algorithm text not null, layout text not null, precision text not null, table_type text not null,
    vertices integer not null, edges integer not null, faces integer not null,
    seed integer not null,  -- 64 bits, written as the signed number of the same bits
    queries integer not null,
    status text not null check(status in ('verified', 'failed', 'unavailable')), reason text not null,
    axes text not null,  -- further axes, NAME=VALUE joined by '+'; empty for the plain cell
    primary key(build, hash)) without rowid;

create table if not exists figure(
    build text not null, hash text not null, probe text not null, name text not null,
    value real, unit text not null, reason text not null, remedy text not null,
    check(value is not null or reason <> ''),
    primary key(build, hash, probe, name)) without rowid;

create table if not exists round(
    build text not null, hash text not null, number integer not null,
    separated_queries integer not null, separated_ns real not null,
    overlapping_queries integer not null, overlapping_ns real not null,
    baseline_separated_queries integer not null, baseline_separated_ns real not null,
    baseline_overlapping_queries integer not null, baseline_overlapping_ns real not null,
    primary key(build, hash, number)) without rowid;
)sql";

}  // namespace edgewise::store
