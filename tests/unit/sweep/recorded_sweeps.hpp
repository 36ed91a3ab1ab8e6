// SPDX-License-Identifier: MIT
//
// What groups of sweeps took, in the order in which they ran, on two cores of an AMD EPYC. A line a group:
// its scene; shape, queries, cells, cells on tables of points, whether caches were modelled; the seconds of
// its four steps. A later run: rows, expected seconds; seconds. Plan quick by the clock, the others in
// processor time: quick with --queries 200 --rounds 3, peers with --queries 300 --rounds 2, and every third
// group of the first 122 of paper with --queries 200 --rounds 3, except bodies of 24578 vertices.
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

inline constexpr const char* recorded_paper_with_options = R"(
paper_static; tetra4 30000 13 1; 0.211 0 0.813 0.296
paper_static; sphere386 30000 13 1; 1.68 0 3.19 1.54
paper_linear_8 bodies=200 least_steps=50 own_tables=1 rotation_step=0; cube8 30000 6 0; 0.0912 0 0.33 0.225
paper_linear_8 bodies=200 least_steps=50 own_tables=1 rotation_step=0; cube8 30000 6 0; 0.1 0 0.355 0.246
paper_linear_8 bodies=200 least_steps=50 own_tables=1 rotation_step=0; cube8 30000 6 0; 0.114 0 0.433 0.311
paper_linear_8 bodies=200 least_steps=50 own_tables=1 rotation_step=0; cube8 30000 6 0; 0.136 0 0.581 0.41
paper_bodies bodies=10 least_steps=50 rotation_step=0.20944; cube8 30000 4 0; 0.0711 0 0.265 0.212
paper_bodies bodies=100 least_steps=50 rotation_step=0.20944; cube8 30000 4 0; 0.0742 0 0.255 0.194
paper_bodies bodies=600 least_steps=50 rotation_step=0.20944; cube8 30000 4 0; 0.0847 0 0.28 0.344
paper_bodies bodies=5000 least_steps=50 rotation_step=0.20944; cube8 30000 4 0; 1.04 0 2.81 4.45
paper_bodies_shrinking bodies=10 least_steps=50 rotation_step=0.20944; cube8 30000 2 0; 0.0532 0 0.161 0.103
paper_bodies_shrinking bodies=100 least_steps=50 rotation_step=0.20944; cube8 30000 2 0; 0.0556 0 0.164 0.0964
paper_bodies_shrinking bodies=600 least_steps=50 rotation_step=0.20944; cube8 30000 2 0; 0.0691 0 0.182 0.181
paper_bodies_shrinking bodies=5000 least_steps=50 rotation_step=0.20944; cube8 30000 2 0; 0.761 0 1.85 2.29
paper_angular_8 bodies=200 least_steps=50 own_tables=1 rotation_step=0; cube8 30000 14 2; 0.132 0 0.643 0.4
paper_angular_8 bodies=200 least_steps=50 own_tables=1 rotation_step=0.05; cube8 30000 14 2; 0.154 0 0.754 0.514
paper_angular_8 bodies=200 least_steps=50 own_tables=1 rotation_step=0.20944; cube8 30000 14 2; 0.198 0 0.916 0.644
paper_angular_8 bodies=200 least_steps=50 own_tables=1 rotation_step=1.61803; cube8 30000 14 2; 0.319 0 1.33 1.02
paper_angular_8 bodies=200 least_steps=50 own_tables=1 rotation_step=3.9; cube8 30000 14 2; 0.343 0 1.42 1.07
paper_angular_8 bodies=200 least_steps=50 own_tables=1 rotation_step=6.2; cube8 30000 14 2; 0.153 0 0.737 0.513
paper_angular_38 bodies=200 least_steps=50 own_tables=1 rotation_step=0; sphere38 30000 14 2; 0.176 0 0.715 0.63
paper_angular_38 bodies=200 least_steps=50 own_tables=1 rotation_step=0.05; sphere38 30000 14 2; 0.222 0 0.857 0.783
paper_angular_38 bodies=200 least_steps=50 own_tables=1 rotation_step=0.20944; sphere38 30000 14 2; 0.317 0 1.16 1.06
paper_angular_38 bodies=200 least_steps=50 own_tables=1 rotation_step=1.61803; sphere38 30000 14 2; 0.522 0 1.84 1.74
paper_angular_38 bodies=200 least_steps=50 own_tables=1 rotation_step=3.9; sphere38 30000 14 2; 0.56 0 1.95 1.82
paper_angular_38 bodies=200 least_steps=50 own_tables=1 rotation_step=6.2; sphere38 30000 14 2; 0.234 0 0.874 0.824
paper_angular_386 bodies=200 least_steps=50 own_tables=1 rotation_step=0; sphere386 30000 14 2; 1.13 0 0.9 2.95
paper_angular_386 bodies=200 least_steps=50 own_tables=1 rotation_step=0.05; sphere386 30000 14 2; 1.27 0 1.38 3.43
paper_angular_386 bodies=200 least_steps=50 own_tables=1 rotation_step=0.20944; sphere386 30000 14 2; 1.6 0 2.64 4.75
paper_angular_386 bodies=200 least_steps=50 own_tables=1 rotation_step=1.61803; sphere386 30000 14 2; 2.29 0 5.21 7.11
paper_angular_386 bodies=200 least_steps=50 own_tables=1 rotation_step=3.9; sphere386 30000 14 2; 2.3 0 5.51 7.34
paper_angular_386 bodies=200 least_steps=50 own_tables=1 rotation_step=6.2; sphere386 30000 14 2; 1.32 0 1.57 3.51
paper_proximity rotation_step=0.00416667; cube8 30000 7 1; 0.0658 0 0.341 0.0889
paper_complexity bodies=12 least_steps=50 rotation_step=0.0166667; cube8 6000 4 0; 0.026 0 0.0212 0.0248
paper_complexity bodies=12 least_steps=50 rotation_step=0.0166667; sphere386 6000 4 0; 0.661 0 0.0397 0.062
paper_cold; cube8 6000 6 0; 0.0511 0 0.0646 0.0732
paper_cold; sphere386 6000 6 0; 1.13 0 0.143 0.215
paper_needs bodies=50 least_steps=50 rotation_step=0.0166667; cube8 6000 36 0; 0.707 0 2.13 1.5
paper_caches_here bodies=75 least_steps=50 own_tables=1 rotation_step=0.116667; sphere386 12000 4 0; 1.31 0 0.266 0.187
paper_caches_here bodies=600 least_steps=50 own_tables=1 rotation_step=0.116667; sphere386 12000 4 0; 1.72 0 1.16 0.584
paper_caches_here bodies=4800 least_steps=50 own_tables=1 rotation_step=0.116667; sphere386 12000 4 0; 8.13 0 19.8 10.3
paper_thrash_8 bodies=300 least_steps=50 own_tables=1 rotation_step=0.0166667; cube8 6000 12 0 caches; 0.0778 11.4 0.295 0.534
paper_thrash_8 bodies=300 least_steps=50 own_tables=1 rotation_step=3.1; cube8 6000 12 0 caches; 0.181 19.8 0.665 1.21
paper_thrash_38 bodies=300 least_steps=50 own_tables=1 rotation_step=0.0166667; sphere38 6000 12 0 caches; 0.1 11.4 0.221 0.708)";

}  // namespace edgewise::sweep
