// SPDX-License-Identifier: MIT
//
// What groups of sweeps took, in the order in which they ran, on two cores of an AMD EPYC. A line a group:
// its scene; shape, queries, cells, cells on tables of points, whether caches were modelled; the seconds of
// its four steps. A later run: rows, expected seconds; seconds. Plan quick by the clock; the others in
// processor time: the same with --queries 200 --rounds 3, and plan peers with --queries 300 --rounds 2.
#pragma once

namespace edgewise::sweep {

inline constexpr const char* recorded_quick = R"(
static; tetra4 3000 31 3; 0.0428 0 0.652 0.415
static; cube8 3000 31 3; 0.0488 0 0.771 0.311
static; sphere38 3000 31 3; 0.0827 0 1.18 0.538
static; sphere386 3000 31 3; 0.296 0 3.32 1.94
cold; tetra4 3000 31 3; 0.04 0 0.51 0.279
cold; cube8 3000 31 3; 0.0457 0 0.571 0.278
cold; sphere38 3000 31 3; 0.0693 0 0.823 0.46
cold; sphere386 3000 31 3; 0.238 0 1.64 1.58
tumble rotation_step=0.01; tetra4 3000 31 3; 0.0183 0 0.22 0.175
tumble rotation_step=0.01; cube8 3000 31 3; 0.0195 0 0.229 0.166
tumble rotation_step=0.01; sphere38 3000 31 3; 0.0287 0 0.286 0.192
tumble rotation_step=0.01; sphere386 3000 31 3; 0.0715 0 0.428 0.37
tumble rotation_step=0.1; tetra4 3000 31 3; 0.0218 0 0.264 0.169
tumble rotation_step=0.1; cube8 3000 31 3; 0.0274 0 0.333 0.194
tumble rotation_step=0.1; sphere38 3000 31 3; 0.049 0 0.481 0.221
tumble rotation_step=0.1; sphere386 3000 31 3; 0.104 0 1.02 0.564
tumble rotation_step=1; tetra4 3000 31 3; 0.0367 0 0.54 0.227
tumble rotation_step=1; cube8 3000 31 3; 0.0455 0 0.675 0.244
tumble rotation_step=1; sphere38 3000 31 3; 0.0741 0 1.09 0.375
tumble rotation_step=1; sphere386 3000 31 3 caches; 0.184 27.9 4.04 1.88
tumble rotation_step=0.1; sphere386 3000 31 3 caches; 0.0979 19.7 1.82 3.07
pressure bodies=600 own_tables=1 rotation_step=0.1; sphere386 1198 10 1 caches; 0.966 23.7 1.26 0.708
pressure bodies=6000 own_tables=1 rotation_step=0.1; sphere386 11998 6 1; 6.14 0 9.61 1.6
stability rows 899 12.6; 15.2)";

inline constexpr const char* recorded_quick_with_options = R"(
static; tetra4 200 31 3; 0.00714 0 0.0242 0.243
static; cube8 200 31 3; 0.00735 0 0.0252 0.131
static; sphere38 200 31 3; 0.0191 0 0.0315 0.245
static; sphere386 200 31 3; 0.106 0 0.0729 1.12
cold; tetra4 200 31 3; 0.00609 0 0.0168 0.113
cold; cube8 200 31 3; 0.00669 0 0.0179 0.126
cold; sphere38 200 31 3; 0.014 0 0.0203 0.236
cold; sphere386 200 31 3; 0.0519 0 0.0336 1.02
tumble rotation_step=0.01; tetra4 200 31 3; 0.00471 0 0.0178 0.0543
tumble rotation_step=0.01; cube8 200 31 3; 0.00455 0 0.0135 0.0506
tumble rotation_step=0.01; sphere38 200 31 3; 0.00984 0 0.0169 0.0856
tumble rotation_step=0.01; sphere386 200 31 3; 0.044 0 0.0233 0.205
tumble rotation_step=0.1; tetra4 200 31 3; 0.00508 0 0.0179 0.0623
tumble rotation_step=0.1; cube8 200 31 3; 0.00544 0 0.0171 0.0658
tumble rotation_step=0.1; sphere38 200 31 3; 0.0123 0 0.0192 0.0892
tumble rotation_step=0.1; sphere386 200 31 3; 0.0477 0 0.0311 0.233
tumble rotation_step=1; tetra4 200 31 3; 0.0064 0 0.0236 0.0656
tumble rotation_step=1; cube8 200 31 3; 0.0074 0 0.0242 0.0797
tumble rotation_step=1; sphere38 200 31 3; 0.0139 0 0.0294 0.116
tumble rotation_step=1; sphere386 200 31 3 caches; 0.052 5.99 0.0496 0.395
tumble rotation_step=0.1; sphere386 200 31 3 caches; 0.0482 5.82 0.0473 0.407
pressure bodies=600 own_tables=1 rotation_step=0.1; sphere386 1198 8 0 caches; 0.52 4.12 0.21 0.197
pressure bodies=6000 own_tables=1 rotation_step=0.1; sphere386 11998 2 0; 1.51 0 1.88 0.276
stability rows 899 12.6; 11.5)";

inline constexpr const char* recorded_peers_with_options = R"(
cold; cube8 300 45 8; 0.0129 0 0.0215 0.144
cold; sphere38 300 45 8; 0.017 0 0.0264 0.189
cold; sphere386 300 45 8; 0.0842 0 0.0696 0.872
cold; sphere1538 300 45 8; 0.288 0 0.185 2.9
gap; cube8 300 19 2; 0.00869 0 0.0159 0.0688
gap; sphere38 300 19 2; 0.0134 0 0.0183 0.121
gap; sphere386 300 19 2; 0.0689 0 0.0531 0.637
gap; sphere1538 300 19 2; 0.233 0 0.16 2.21
gap; cube8 300 19 2; 0.0125 0 0.0182 0.0765
gap; sphere38 300 19 2; 0.0216 0 0.0267 0.134
gap; sphere386 300 19 2; 0.129 0 0.0983 0.71
gap; sphere1538 300 19 2; 0.458 0 0.316 2.59
gap; cube8 300 19 2; 0.011 0 0.0176 0.0753
gap; sphere38 300 19 2; 0.0178 0 0.0222 0.128
gap; sphere386 300 19 2; 0.0976 0 0.0727 0.676
gap; sphere1538 300 19 2; 0.338 0 0.236 2.27
gap; cube8 300 19 2; 0.00679 0 0.0119 0.0567
gap; sphere38 300 19 2; 0.0101 0 0.0145 0.108
gap; sphere386 300 19 2; 0.0519 0 0.0427 0.577
gap; sphere1538 300 19 2; 0.186 0 0.135 2.03
tumble rotation_step=0.001; cube8 300 19 2; 0.00588 0 0.0121 0.0282
tumble rotation_step=0.001; sphere38 300 19 2; 0.00859 0 0.0147 0.0451
tumble rotation_step=0.001; sphere386 300 19 2; 0.0425 0 0.0457 0.318
tumble rotation_step=0.001; sphere1538 300 19 2; 0.152 0 0.147 1.17
tumble rotation_step=0.01; cube8 300 19 2; 0.00571 0 0.0121 0.0285
tumble rotation_step=0.01; sphere38 300 19 2; 0.00842 0 0.0149 0.0493
tumble rotation_step=0.01; sphere386 300 19 2; 0.0423 0 0.0463 0.332
tumble rotation_step=0.01; sphere1538 300 19 2; 0.151 0 0.145 1.37
tumble rotation_step=0.1; cube8 300 33 6; 0.00849 0 0.0173 0.06
tumble rotation_step=0.1; sphere38 300 33 6; 0.0128 0 0.0211 0.0909
tumble rotation_step=0.1; sphere386 300 33 6; 0.0607 0 0.0614 0.482
tumble rotation_step=0.1; sphere1538 300 33 6; 0.211 0 0.175 1.77
tumble rotation_step=1; cube8 300 19 2; 0.00839 0 0.0179 0.0385
tumble rotation_step=1; sphere38 300 19 2; 0.0117 0 0.0222 0.0682
tumble rotation_step=1; sphere386 300 19 2; 0.0484 0 0.0585 0.385
tumble rotation_step=1; sphere1538 300 19 2; 0.162 0 0.173 1.4
tumble random_orientation=1 rotation_step=0.01; cube8 300 19 2; 0.00857 0 0.0185 0.0391
tumble random_orientation=1 rotation_step=0.01; sphere38 300 19 2; 0.0123 0 0.0219 0.0677
tumble random_orientation=1 rotation_step=0.01; sphere386 300 19 2; 0.0484 0 0.0596 0.38
tumble random_orientation=1 rotation_step=0.01; sphere1538 300 19 2; 0.162 0 0.17 1.36
pressure bodies=600 own_tables=1 rotation_step=0.1; cube8 5990 31 4; 0.11 0 0.187 0.162
pressure bodies=600 own_tables=1 rotation_step=0.1; sphere38 5990 31 4; 0.339 0 0.4 0.329
pressure bodies=600 own_tables=1 rotation_step=0.1; sphere386 5990 31 4; 2.82 0 2.05 1.62
pressure bodies=6000 own_tables=1 rotation_step=0.1; cube8 11998 31 4; 0.472 0 0.965 0.406
pressure bodies=6000 own_tables=1 rotation_step=0.1; sphere38 11998 31 4; 2.15 0 1.84 0.98
pressure bodies=6000 own_tables=1 rotation_step=0.1; sphere386 11998 31 4; 22.1 0 6.84 5.73
pressure bodies=6000 rotation_step=0.1; cube8 11998 19 2; 0.145 0 0.391 0.148
pressure bodies=6000 rotation_step=0.1; sphere38 11998 19 2; 0.267 0 0.639 0.262
pressure bodies=6000 rotation_step=0.1; sphere386 11998 19 2; 1.31 0 2.58 0.962
effort rows 19 76; 93)";

}  // namespace edgewise::sweep
