-- SPDX-License-Identifier: MIT
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
    status text not null check(status in ('verified', 'failed', 'unavailable', 'judged')), reason text not null,
    axes text not null,  -- further axes, NAME=VALUE joined by '+'; empty for the plain cell
    run text not null default 'sweep',  -- what measured it: a sweep, or the study of that name
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
    either_queries integer not null, either_ns real not null,  -- not known to be of either kind
    first_queries integer not null, first_ns real not null,  -- cold ones of followed pairs, in none of the others
    primary key(build, hash, number)) without rowid;
