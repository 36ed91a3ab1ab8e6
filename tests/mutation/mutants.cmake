# SPDX-License-Identifier: MIT
# NAME, file under src/edgewise/, the code, the bug, the cases that must find it, the test's sources.

# Controls: no bug, and the cases must pass. One in a header, one in a source.
edgewise_mutant(control_header algorithms/support.hpp [[if (may_climb(table) && table.vertex_count() >= scan_under)]] [[if (may_climb(table) && table.vertex_count() >= scan_under)]]
    Climb.* ${unit}/algorithms/support_test.cpp)
edgewise_mutant(control_source truth/exact_distance.cpp [[while (!simplex.holds_origin()) {]] [[while (!simplex.holds_origin()) {]]
    ExactDistance.* ${unit}/truth/exact_distance_test.cpp)

# Geometry
edgewise_mutant(relative_pose_not_transposed geometry/pose.hpp [[= a.rotation(0, i) * b.rotation.row(0) +]] [[= a.rotation(i, 0) * b.rotation.row(0) +]]
    Pose.RelativePose* ${unit}/geometry/pose_test.cpp)
edgewise_mutant(plane_offset_sign geometry/vec.hpp [[dot(normal, p) + offset]] [[dot(normal, p) - offset]]
    RandomPairs* ${random_pairs})
edgewise_mutant(bent_faces_count_as_flat geometry/strictly_convex.cpp [[|| turns.is_bent(f)]] [[]]
    StrictlyConvex.ABentFace* ${unit}/geometry/flat_hull_test.cpp)
edgewise_mutant(flat_corners_count_as_turns geometry/strictly_convex.cpp [[dot(from, to) <= 0 ? 1]] [[dot(from, to) >= 0 ? 1]]
    StrictlyConvex.* ${unit}/geometry/flat_hull_test.cpp)

# Table
set(ring_questions ${PROJECT_SOURCE_DIR}/tests/contract/ring_question_test.cpp)
edgewise_mutant(least_violated_plane table/ring_questions.hpp [[if (d < least) worst]] [[if (d < 0) worst]]
    RingQuestions* ${ring_questions})
edgewise_mutant(descent_ignores_flip table/ring_questions.hpp [[flipped ? -along : along]] [[flipped ? along : along]]
    RingQuestions* ${ring_questions})
edgewise_mutant(right_plane_turned_in layout_parts/voronoi.hpp [[edge.right, Vec3d(-result.direction), tail]] [[edge.right, Vec3d(result.direction), tail]]
    RandomPairs* ${random_pairs})

# GJK
edgewise_mutant(johnson_never_backs_up algorithms/johnson.hpp [[if (least < 0 || squared < least) {]] [[if (least < 0) {]]
    Johnson.* ${unit}/algorithms/johnson_test.cpp)
edgewise_mutant(johnson_volume_sign algorithms/johnson.hpp [[(k & 1 ? -1 : 1)]] [[(k & 2 ? -1 : 1)]]
    Johnson.* ${unit}/algorithms/johnson_test.cpp)
edgewise_mutant(johnson_foot_of_slivers algorithms/subset.hpp [[if (sliver || height]] [[if (height]]
    Johnson.* ${unit}/algorithms/johnson_test.cpp)
edgewise_mutant(cofactors_ask_no_second_opinion algorithms/cofactors.hpp [[if (count == 4) return weigh_passing<4, newest_belongs>(w, found);]]
    [[if (count == 4) return weigh_passing<4, newest_belongs>(w, found) || true;]] Cofactors.* ${unit}/algorithms/johnson_test.cpp)
edgewise_mutant(johnson_is_not_asked algorithms/sub_distance.hpp [[return solver == SubDistanceSolver::cofactors ? Way::cofactors : Way::johnson;]] [[return Way::cofactors;]]
    SubDistances/* ${unit}/algorithms/sub_distance_test.cpp)
edgewise_mutant(batch_takes_cutoffs_into_lanes algorithms/query_batch.hpp [[ && std::isinf(options.cutoff)]] [[]]
    ParallelBatches/*HonourTheOptions* ${unit}/algorithms/parallel_batch_test.cpp)
edgewise_mutant(batch_takes_johnson_into_lanes algorithms/query_batch.hpp [[options.sub_distance == SubDistanceSolver::cofactors && std::isinf(options.cutoff)]] [[std::isinf(options.cutoff)]]
    SubDistances/* ${unit}/algorithms/sub_distance_test.cpp)
edgewise_mutant(johnson_does_not_reach_the_run algorithms/gjk.hpp [[Base(a, b, a_from_b, options.sub_distance),]] [[Base(a, b, a_from_b, SubDistanceSolver::cofactors),]]
    SubDistances/* ${unit}/algorithms/sub_distance_test.cpp)
edgewise_mutant(upper_proof_is_skipped algorithms/subset.hpp [[return squared_norm(Vec3<Scalar>(on_a - on_b)) <= most * most;]] [[return true;]]
    WitnessPoints.* ${unit}/algorithms/kept_simplex_test.cpp)
edgewise_mutant(lower_proof_is_skipped algorithms/kept_simplex.hpp [[return squared - reach(closest_.point) <= open * distance_;]] [[return true;]]
    KeptSimplex.* ${unit}/algorithms/kept_simplex_test.cpp)
edgewise_mutant(box_edges_by_a_constant algorithms/box_verdict.hpp [[least * (part_p + part_q)]] [[least]]
    BoxVerdict.* ${unit}/algorithms/box_verdict_test.cpp)
edgewise_mutant(box_tolerance_by_axes_alone algorithms/box_verdict.hpp [[contact_tolerance == 0 || !boxes.separate(0, axis)]] [[true]]
    BoxVerdict.* ${unit}/algorithms/box_verdict_test.cpp)
set(search ${unit}/algorithms/single_search_test.cpp ${PROJECT_SOURCE_DIR}/src/edgewise/algorithms/search/single_search.cpp)
edgewise_mutant(search_is_believed algorithms/early_answer.hpp [[if (!kept.is_proven(options_)) return false;]]
    [[static_cast<void>(kept.is_proven(options_));]] GjkNearContact.* ${unit}/algorithms/near_contact_test.cpp)
edgewise_mutant(search_leaves_the_origin algorithms/search/sides.hpp [[r = -s;]] [[r = s;]] SingleSearch.* ${search})
edgewise_mutant(search_takes_the_wrong_face algorithms/search/sides.hpp [[l = next_s * h - s * next_g;]] [[l = next_s * h + s * next_g;]]
    SingleSearch.* ${search})
edgewise_mutant(search_keeps_no_faces algorithms/search/sides.hpp [[return face | last(face) | edge;]] [[return face | edge;]] SingleSearch.* ${search})
edgewise_mutant(mixed_lanes_scan_large_bodies_alone algorithms/search/lane_bodies.hpp [[if (by_rows_ != all_lanes)]] [[if (by_rows_ == 0)]]
    ParallelBatches/*TakeAnyNumber* ${unit}/algorithms/parallel_batch_test.cpp
    ${PROJECT_SOURCE_DIR}/src/edgewise/algorithms/search/single_search.cpp)
edgewise_mutant(depth_has_one_radius algorithms/rounded.hpp [[found.depth += a.radius + b.radius;]] [[found.depth += a.radius;]]
    Rounded.* ${unit}/algorithms/rounded_test.cpp)
edgewise_mutant(kept_direction_unturned algorithms/kept_simplex.hpp [[dot(normal, difference_[0]) < 0 ? Vec3<Number>(-normal) : normal]] [[normal]]
    KeptSimplex.* ${unit}/algorithms/kept_simplex_test.cpp)
edgewise_mutant(kept_direction_forgets_the_cutoff algorithms/kept_simplex.hpp [[(cutoff + Tolerance<Number>::support_noise * size_)]] [[(Tolerance<Number>::support_noise * size_)]]
    KeptSimplex.* ${unit}/algorithms/kept_simplex_test.cpp)
edgewise_mutant(contact_in_the_whole_band algorithms/vclip/trust.hpp [[double{Tolerance<ComputeOf<TableA>>::meeting}]] [[double{Tolerance<ComputeOf<TableA>>::contact_noise}]]
    VClipNearContact.* ${unit}/algorithms/nearly_parallel_edges_test.cpp)
edgewise_mutant(height_of_any_vertex algorithms/support.hpp [[return highest <= height + band ?]] [[return true ?]]
    GreatestHeight.* ${unit}/algorithms/support_test.cpp)
edgewise_mutant(height_in_a_dent algorithms/support.hpp [[if (!table.strictly_convex()) return std::nullopt;]] [[]]
    GreatestHeight.* ${unit}/algorithms/support_test.cpp)
edgewise_mutant(far_pairs_ask_corners_first algorithms/vclip.hpp [[first = next_try(result, FirstTry::walk);]] [[]]
    CloseBodies.* ${unit}/algorithms/kept_simplex_test.cpp)
edgewise_mutant(close_pairs_walk_first algorithms/vclip.hpp [[return is_close && known != FirstTry::nearer_start ? FirstTry::corners : known;]] [[return known;]]
    CloseBodies.* ${unit}/algorithms/kept_simplex_test.cpp)
edgewise_mutant(kept_edges_are_lines algorithms/kept_simplex.hpp [[return t >= 0 && t <= 1;]] [[return true;]]
    KeptSimplex.* ${unit}/algorithms/kept_simplex_test.cpp)
edgewise_mutant(climb_first_neighbour_only algorithms/support.hpp [[if (improved) continue;]] [[]]
    *Support* ${unit}/algorithms/support_test.cpp)
edgewise_mutant(climb_stops_at_level_vertices algorithms/support.hpp [[|| !leave_level(table, direction, band, best)) return best;]] [[|| true) return best;]]
    Climb* ${unit}/algorithms/support_test.cpp)
edgewise_mutant(inward_edges_are_climbed geometry/strictly_convex.cpp [[return dot(turn, side) >= least_ * reach_;]] [[return true;]]
    StrictlyConvex.* ${unit}/geometry/flat_hull_test.cpp)
edgewise_mutant(seeds_of_the_other_side layout_parts/seed_directions.hpp [[static_cast<int>(x > least) - static_cast<int>(x < -least)]] [[static_cast<int>(x < -least) - static_cast<int>(x > least)]]
    Seeds* ${unit}/layout_parts/seeds_test.cpp)
edgewise_mutant(thin_sides_derived_plainly layout_parts/derived/thin_corners.hpp [[return plain - dot(along, plain) / squared_norm(along) * along;]] [[return plain;]]
    ThinCorners* ${unit}/layout_parts/thin_corners_test.cpp)
edgewise_mutant(thinnest_sides_derived_plainly layout_parts/derived/thin_corners.hpp [[Tolerance<Scalar>::tilting_corner * most]] [[0]]
    ThinCorners* ${unit}/layout_parts/thin_corners_test.cpp)
edgewise_mutant(thin_corners_overlooked layout_parts/derived/thin_corners.hpp [[if (is_thin(f)) return true;]] [[if (is_thin(f)) return false;]]
    ThinCorners* ${unit}/layout_parts/thin_corners_test.cpp)
edgewise_mutant(grid_cells_of_the_other_side layout_parts/seed_directions.hpp [[(along < 0 ? 1 : 0)]] [[(along < 0 ? 0 : 1)]]
    Seeds* ${unit}/layout_parts/seeds_test.cpp)
edgewise_mutant(far_neighbours_are_near layout_parts/relative_table.hpp [[return in.far_neighbours(base).read(loader, low, Field::neighbour);]] [[return low;]]
    RelativeRings.Are* ${unit}/layout_parts/relative_rings_test.cpp)
edgewise_mutant(bounds_forget_the_turn algorithms/distance_bounds.hpp [[turned * squared_radius_]] [[0 * turned]]
    NearPair* ${unit}/algorithms/near_pair_test.cpp)
edgewise_mutant(mirrored_poses_answered algorithms/answerable.hpp [[z.z() - (x.x() * y.y() - x.y() * y.x())]] [[std::abs(z.z()) - std::abs(x.x() * y.y() - x.y() * y.x())]] Answerable* ${unit}/algorithms/answerable_test.cpp)
edgewise_mutant(squares_add_as_lengths algorithms/distance_bounds.hpp [[2 * (squared_shift + squared_turn) < left]]
    [[(squared_shift + squared_turn) < left]] NearPair* ${unit}/algorithms/near_pair_test.cpp)
edgewise_mutant(scan_takes_the_lowest algorithms/support.hpp [[if (along > best.along) best = {v, point, along};]] [[if (along < best.along) best = {v, point, along};]]
    *Support* ${unit}/algorithms/support_test.cpp)
edgewise_mutant(gjk_ends_at_once algorithms/sub_distance.hpp [[if (!gains(squared) && !retry_in_wide_arithmetic(separates)) {]] [[if (gains(squared)) {]]
    RandomPairs* ${random_pairs})
edgewise_mutant(gjk_direction_not_turned_back algorithms/gjk.hpp [[a_from_b_.direction_back(v)]] [[a_from_b_.direction(v)]]
    RandomPairs* ${random_pairs})
edgewise_mutant(verdict_without_a_direction algorithms/gjk.hpp [[if (reach_ - noise > cutoff_ * root)]] [[if (options_.has_cutoff())]]
    *OfAVerdict* ${unit}/algorithms/normal_test.cpp)
edgewise_mutant(verdict_goes_on_to_the_distance algorithms/gjk.hpp [[if (reach_ - noise > cutoff_ * root)]] [[if (false)]]
    *OfAVerdict* ${unit}/algorithms/normal_test.cpp)
edgewise_mutant(verdict_forgets_the_tolerance algorithms/gjk.hpp [[reach_ - noise > cutoff_ * root]] [[options_.has_cutoff() && reach_ > noise]]
    *OfAVerdict* ${unit}/algorithms/normal_test.cpp)
edgewise_mutant(normal_points_from_b_to_a algorithms/subset.hpp [[(-1 / distance)]] [[(1 / distance)]]
    *Normal* ${unit}/algorithms/normal_test.cpp)
edgewise_mutant(old_pairs_are_followed algorithms/penetration/start.hpp [[if (!pair.belongs_to(a, b)) return SimplexPair<TableA, TableB>(a, b);]] [[]]
    RebuiltTable* ${unit}/algorithms/rebuilt_table_test.cpp)

edgewise_mutant(parts_answer_in_the_first_places algorithms/parallel_batch.hpp [[answers.subspan(first, count)]] [[answers.subspan(0, count)]]
    ParallelBatches/*AreToTheBit* ${unit}/algorithms/parallel_batch_test.cpp)
edgewise_mutant(batch_stays_in_one_thread algorithms/parallel_batch.hpp [[tbb::task_arena arena(threads);]] [[tbb::task_arena arena(1);]]
    ParallelBatch.AsksInSoManyThreads ${unit}/algorithms/parallel_batch_test.cpp)
edgewise_mutant(frames_ask_a_pair_again bench/frame_batches.hpp [[= asked[pair_of(i)]++;]] [[= asked[pair_of(i)];]]
    FrameBatches.AskNoPairTwice* ${unit}/bench/frame_batches_test.cpp)
edgewise_mutant(other_sums_pass studies/threads/scaling.cpp [[if (sum == single) return {};]] [[return {};]]
    Scaling.HoldsSums* ${unit}/studies/scaling_test.cpp)

edgewise_mutant(pairs_keep_any_handle algorithms/simplex_pair.hpp [[return corner.a <= handle && corner.b <= handle;]] [[return true;]]
    PairCache.* ${unit}/algorithms/pair_cache_test.cpp)
edgewise_mutant(features_of_old_tables_are_followed algorithms/vclip/feature_pair.hpp [[if (!belongs_to(table_a, table_b)) return Features<TableA, TableB>::first_of(table_a, table_b);]] [[]]
    RebuiltTable.* ${unit}/algorithms/rebuilt_table_test.cpp)

# V-Clip
edgewise_mutant(flat_ends_are_proven algorithms/vclip/trust.hpp [[return body_ends_here(a, towards_b, size) &&]] [[return true || body_ends_here(a, towards_b, size) &&]]
    RawWalk.* ${unit}/algorithms/raw_walk_test.cpp)
edgewise_mutant(level_neighbours_are_lower algorithms/vclip/trust.hpp [[!(dot(down, direction) > band)]] [[!(dot(down, direction) >= -band)]]
    RawWalk.* ${unit}/algorithms/raw_walk_test.cpp)
edgewise_mutant(close_normal_by_witness_points algorithms/vclip/trust.hpp [[result.normal = *normal;]] [[]]
    *Normal* ${unit}/algorithms/normal_test.cpp)
edgewise_mutant(clip_takes_the_nearer_end algorithms/vclip/clip.hpp [[if (lambda > low) {]] [[if (lambda < low) {]]
    Clip.* ${unit}/algorithms/clip_test.cpp)
edgewise_mutant(clip_forgets_simple_exclusion algorithms/vclip/clip.hpp [[if (tail < 0 && head < 0) return Clipped::simply_excluded;]] [[if (tail < 0 && head < 0) return Clipped::inside;]]
    Clip.* ${unit}/algorithms/clip_test.cpp)
edgewise_mutant(parallel_edges_divide algorithms/vclip/closest_points.hpp [[return inside && squared_ >= fair;]] [[return inside;]]
    ClosestOn* ${unit}/algorithms/closest_points_test.cpp)
edgewise_mutant(segments_not_clamped algorithms/vclip/closest_points.hpp [[std::clamp(projection(segment.tail, along, point), Scalar(0), Scalar(1))]] [[projection(segment.tail, along, point)]]
    ClosestOn* ${unit}/algorithms/closest_points_test.cpp)
edgewise_mutant(proof_asks_one_face layout_parts/derived/derived_ends.hpp [[height_of(rings().neighbour(loader_, h.vertex, after), base, direction) <= level;]] [[true;]]
    StillClosest.Proves* ${unit}/algorithms/still_closest_test.cpp)
edgewise_mutant(proof_of_any_face layout_parts/derived/derived_ends.hpp [[is_beside(normal, second, third, point) ||]] [[]]
    StillClosest.Proves* ${unit}/algorithms/still_closest_test.cpp)
edgewise_mutant(proof_by_level_neighbours layout_parts/derived/derived_ends.hpp [[return level_decides ? Compute(0)]] [[return true ? Compute(0)]]
    StillClosest.ProvesOfThinCorners* ${unit}/algorithms/still_closest_test.cpp)
edgewise_mutant(proof_over_thin_faces layout_parts/derived/derived_ends.hpp [[return !facts_.thin_corners || squared]] [[return true || squared]]
    StillClosest.ProvesOfThinCorners* ${unit}/algorithms/still_closest_test.cpp)
edgewise_mutant(proof_of_flat_bodies layout_parts/derived/derived_ends.hpp [[return facts_.climbable && facts_]] [[return facts_]]
    StillClosest.ProvesNothing* ${unit}/algorithms/still_closest_test.cpp)
edgewise_mutant(far_off_simplex_kept algorithms/gjk_start.hpp [[return squared > farthest * farthest;]] [[return farthest < 0;]]
    MovedFar.* ${unit}/algorithms/moved_far_test.cpp)
edgewise_mutant(long_walks_go_on algorithms/vclip/nearer_start.hpp [[return is_small(a) && is_small(b) ? steps_before_search]] [[return is_small(a) && is_small(b) ? -1]]
    NearerStart.* ${unit}/algorithms/nearer_start_test.cpp)
edgewise_mutant(long_walks_over_large_bodies_go_on algorithms/vclip/nearer_start.hpp [[: steps_before_climb;]] [[: -1;]]
    NearerStart.* ${unit}/algorithms/nearer_start_test.cpp)
edgewise_mutant(useless_starts_are_sought_again algorithms/vclip/nearer_start.hpp [[steps_before_climb ? FirstTry::walk_on : known.next;]] [[steps_before_climb ? known.next : known.next;]]
    NearerStart.* ${unit}/algorithms/nearer_start_test.cpp)
edgewise_mutant(far_moves_forgotten algorithms/vclip.hpp [[pair = {a, b, end, first};]] [[pair = {a, b, end};]]
    NearerStart.* ${unit}/algorithms/nearer_start_test.cpp)
edgewise_mutant(far_moves_never_over algorithms/vclip/nearer_start.hpp [[if (start == Start::nearer && !is_cold) return]] [[if (start == Start::nearer || !is_cold) return]]
    NearerStart.* ${unit}/algorithms/nearer_start_test.cpp)
edgewise_mutant(cold_start_anywhere algorithms/vclip/nearer_start.hpp [[const bool is_cold = start_is_cold(a, b);]] [[const bool is_cold = false;]]
    NearerStart.* ${unit}/algorithms/nearer_start_test.cpp)
edgewise_mutant(box_points_stay algorithms/vclip/box_start.hpp [[            move();]] [[            if (round > 0) move();]]
    BoxStart.* ${unit}/algorithms/box_verdict_test.cpp)
edgewise_mutant(box_start_leaves_the_end algorithms/vclip/nearer_start.hpp [[!(points.squared_distance() < squared_norm]] [[!(0 < squared_norm]]
    BoxStart.* ${unit}/algorithms/box_verdict_test.cpp)
edgewise_mutant(box_start_is_remembered algorithms/vclip/nearer_start.hpp [[return steps == std::max(known.far_off, 1) ? known.next : FirstTry::walk;]] [[return known.next;]]
    NearerStart.OfBoxes* ${unit}/algorithms/nearer_start_test.cpp)
edgewise_mutant(box_overlap_by_two_axes algorithms/vclip/box_start.hpp [[std::abs(in_a(0)) < half_a_[0] - margin && ]] [[]]
    BoxStart.* ${unit}/algorithms/box_verdict_test.cpp)
edgewise_mutant(pierced_beside_the_face layout_parts/derived/derived_ends.hpp [[within &= (rise > 0 ? volume : -volume) > least_volume * norm(side);]] [[]]
    StillClosest.* ${unit}/algorithms/still_closest_test.cpp)
edgewise_mutant(pierced_beyond_the_edge layout_parts/derived/derived_ends.hpp [[std::abs(rise) - to_plane > least_height]] [[true]]
    StillClosest.* ${unit}/algorithms/still_closest_test.cpp)
edgewise_mutant(proof_along_short_directions layout_parts/derived/derived_ends.hpp [[ && !is_short;]] [[;]]
    NearlyParallelEdges.* ${unit}/algorithms/nearly_parallel_edges_test.cpp)
edgewise_mutant(cycle_never_seen algorithms/vclip/cycle_guard.hpp [[if (a == a_ && b == b_) return true;]] [[if (a == a_ && b == b_) return false;]]
    CycleGuard.BothFeaturesCount ${unit}/algorithms/cycle_guard_test.cpp)
edgewise_mutant(cycle_by_one_feature algorithms/vclip/cycle_guard.hpp [[a == a_ && b == b_]] [[a == a_ || b == b_]]
    CycleGuard.* ${unit}/algorithms/cycle_guard_test.cpp)
edgewise_mutant(edge_leaves_to_the_nearer_face algorithms/vclip/vertex_edge.hpp [[if (!(left > 0) && !(right > 0)) return false;]] [[if (!(left > 0) || !(right > 0)) return false;]]
    RandomPairs* ${random_pairs})
edgewise_mutant(edge_face_wrong_slope algorithms/vclip/edge_face.hpp [[low > 0 ? slope >= 0 : slope <= 0]] [[low > 0 ? slope <= 0 : slope >= 0]]
    RandomPairs* ${random_pairs})
edgewise_mutant(edge_edge_ignores_faces algorithms/vclip/edge_edge.hpp [[return leave_to_vertex() || leave_to_face();]] [[return leave_to_vertex();]]
    RandomPairs* ${random_pairs})
edgewise_mutant(no_escape_from_below algorithms/vclip/vertex_face.hpp [[if (highest <= 0) return Step::touching;]] [[return Step::touching;]]
    RandomPairs* ${random_pairs})

# Penetration
edgewise_mutant(exact_side_by_rounding algorithms/penetration/expansion.hpp [[return exact_side(a, b, c, point);]] [[return volume > 0 ? 1 : -1;]]
    ExactSide.* ${unit}/algorithms/exact_side_test.cpp)
edgewise_mutant(product_without_its_error algorithms/penetration/expansion.hpp [[add(abc.low);]] [[]]
    ExactSide.* ${unit}/algorithms/exact_side_test.cpp)

# Broad phase and the paper's referee
edgewise_mutant(sweep_misses_touching algorithms/sweep_and_prune.hpp [[low[axis] > box.high[axis]) break;]] [[low[axis] >= box.high[axis]) break;]]
    SweepAndPrune.* ${unit}/algorithms/sweep_and_prune_test.cpp)

edgewise_mutant(referee_without_edges truth/moore_wilhelms.hpp [[return enter < leave;]] [[return false;]]
    MooreWilhelms.* ${unit}/truth/enclosure_test.cpp)

# Truth
edgewise_mutant(oracle_stops_early truth/exact_distance.cpp [[while (!simplex.holds_origin()) {]] [[for (int i = 0; i < 1 && !simplex.holds_origin(); ++i) {]]
    ExactDistance.* ${unit}/truth/exact_distance_test.cpp)
edgewise_mutant(filter_without_margin truth/exact_body.cpp [[.height - 2 * Tolerance<double>::support_filter]] [[.height + 1e-12]]
    ExactDistance*:ExactVerdict* ${unit}/truth/exact_distance_test.cpp ${unit}/truth/exact_verdict_test.cpp)
edgewise_mutant(proof_takes_negative_weights truth/exact_proof.cpp [[if (sgn(weights[i]) < 0) return false;]] [[if (sgn(weights[i]) < -1) return false;]]
    ExactDistance.proof* ${unit}/truth/exact_distance_test.cpp)
edgewise_mutant(certificate_rounds_inward truth/certificate.cpp [[std::nextafter(stored.upper + error, infinity)]] [[std::nextafter(stored.upper + error, -infinity)]]
    Certificate.widen* ${unit}/truth/certificate_test.cpp)
edgewise_mutant(certificate_looks_along_one_way truth/certificate.cpp [[std::max(bodies.lowest(direction).height, bodies.lowest(-direction).height)]] [[bodies.lowest(direction).height]]
    Certificate.* ${unit}/truth/certificate_test.cpp)
edgewise_mutant(touching_counts_as_overlap truth/exact_distance.cpp [[interior ? ExactVerdict::overlapping : ExactVerdict::touching]] [[interior ? ExactVerdict::touching : ExactVerdict::touching]]
    ExactVerdict.* ${unit}/truth/exact_verdict_test.cpp)
edgewise_mutant(band_without_rotations truth/accuracy_band.hpp [[verdict_band_ortho * ortho]] [[0 * ortho]]
    AccuracyBand.* ${unit}/truth/checked_answer_test.cpp)
edgewise_mutant(judge_lets_nan_pass truth/checked_answer.cpp [[(claim.separated && std::isnan(claim.distance))]] [[false]]
    CheckedAnswer.* ${unit}/truth/checked_answer_test.cpp)

# Cache model
edgewise_mutant(sets_by_the_wrong_bits measure/cache/cache_model.hpp [[return mask_ != 0 ? line & (mask_ - 1)]] [[return mask_ != 0 ? line >> 1 & (mask_ - 1)]]
    CacheModel.* ${unit}/measure/cache_model_test.cpp)
edgewise_mutant(the_newest_line_leaves measure/cache/cache_model.cpp [[std::min_element(times, times + ways_) - times]] [[std::max_element(times, times + ways_) - times]]
    CacheModel.* ${unit}/measure/cache_model_test.cpp)
edgewise_mutant(every_query_starts_warm measure/cache/scene_caches.cpp [[levels_.each(start,]] [[levels_.each(start ? QueryStart::warm : start,]]
    SceneCaches.* ${unit}/measure/scene_caches_test.cpp)
edgewise_mutant(what_lies_between_queries_is_the_lasts measure/cache/scene_caches.cpp [[start_.reset();]] [[]]
    SceneCaches.* ${unit}/measure/scene_caches_test.cpp)
edgewise_mutant(axes_stand_still scene/motion.cpp [[if (p.w != 1)]] [[if (p.w == 2)]]
    Tumble.* ${unit}/scene/tumble_test.cpp)

# A user's own structures, locks and traces
edgewise_mutant(fetches_come_in_always measure/traces/trace_file.cpp [[if (reading.fetches) use(]] [[use(]]
    TraceFile.* ${unit}/measure/trace_file_test.cpp)
edgewise_mutant(modifies_are_reads_alone measure/traces/trace_file.cpp [[if (access.label != read) {]] [[if (access.label == write) {]]
    TraceFile.* ${unit}/measure/trace_file_test.cpp)
edgewise_mutant(far_lines_are_one measure/traces/trace_file.cpp [[numbers_.try_emplace(line,]] [[numbers_.try_emplace(line % 64,]]
    TraceCaches.* ${unit}/measure/trace_file_test.cpp)
edgewise_mutant(arrays_begin_anywhere measure/touch/touch_trace.cpp [[(next_ + alignment - 1) / alignment * alignment]] [[next_]]
    Structure.* ${unit}/measure/touch_trace_test.cpp)
edgewise_mutant(places_are_addresses measure/touch/touch_trace.cpp [[return in.place + (from - in.from);]] [[return from;]]
    Structure.* ${unit}/measure/touch_trace_test.cpp)
edgewise_mutant(what_is_gone_is_no_difference measure/record/comparison.cpp [[add_lone_rows(before, after,]] [[if (false) add_lone_rows(before, after,]]
    Record.* ${unit}/measure/record_test.cpp)
edgewise_mutant(what_is_new_is_no_difference measure/record/comparison.cpp [[add_lone_rows(after, before,]] [[if (false) add_lone_rows(after, before,]]
    Record.* ${unit}/measure/record_test.cpp)

# Effort
edgewise_mutant(startup_is_counted studies/effort/effort.cpp [[return (of_many - of_few) / passes / queries;]] [[return of_many / passes / queries;]]
    Effort.Counts* ${unit}/studies/effort_test.cpp)
edgewise_mutant(calls_are_counted_twice measure/process/callgrind.cpp [[if (is_call_)]] [[if (is_call_ && false)]]
    CallgrindLines.* ${unit}/measure/callgrind_test.cpp)
edgewise_mutant(every_function_runs_once studies/phases/phases.cpp [[in_steps += cost * steps_at(call->from, said);]] [[]]
    PhaseCounts.* ${unit}/studies/phases_test.cpp)
edgewise_mutant(phases_need_not_add_up studies/phases/phases.cpp [[if (sum == total) return {};]] [[return {};]]
    PhaseCounts.* ${unit}/studies/phases_test.cpp)
edgewise_mutant(floor_without_itself studies/effort/effort.cpp [[1 + body.ring_of_vertex(v).size()]] [[body.ring_of_vertex(v).size()]]
    ProofFloor.* ${unit}/studies/proof_floor_test.cpp)

# Speed against a baseline
edgewise_mutant(the_median_alone_fails measure/record/comparison.cpp [[if (is.low > was.high * limit)]] [[if (is.value > was.high * limit)]]
    Record.* ${unit}/measure/record_test.cpp)
edgewise_mutant(a_slowdown_needs_all_of_two_intervals studies/gate/run.cpp [[row.low = row.high = row.value;]] [[row.low = row.value;]]
    SpeedRecord.* ${unit}/studies/speed_record_test.cpp)
edgewise_mutant(a_second_look_accuses studies/gate/run.cpp [[if (second->low < row.low)]] [[if (second->low > row.low)]]
    SpeedRecord.* ${unit}/studies/speed_record_test.cpp)
edgewise_mutant(nothing_compared_passes measure/record/comparison.cpp [[return faults.empty() && compared() > 0 &&]] [[return faults.empty() &&]]
    Record.* ${unit}/measure/record_test.cpp)

# The rules of claims
edgewise_mutant(too_much_is_no_miss reports/paper/claims/claim_rules.cpp [[ours.high < part.wanted.low || ours.low > part.wanted.high]] [[ours.high < part.wanted.low]]
    *EveryClaim*:Claims.* ${claims})
edgewise_mutant(straddling_is_met reports/paper/claims/claim_rules.cpp [[ours.low < part.wanted.low || ours.high > part.wanted.high]] [[ours.low < part.wanted.low && ours.high > part.wanted.high]]
    Claims.* ${claims})

# The Pareto front of time and error
edgewise_mutant(equal_points_beat_each_other reports/tables/fronts.cpp [[if (last && !equal && point.ns >= last->ns) continue;]] [[if (last && point.ns >= last->ns) continue;]]
    ParetoFront.* ${unit}/reports/pareto_front_test.cpp)
edgewise_mutant(as_slow_is_no_worse reports/tables/fronts.cpp [[if (last && !equal && point.ns >= last->ns) continue;]] [[if (last && !equal && point.ns > last->ns) continue;]]
    ParetoFront.* ${unit}/reports/pareto_front_test.cpp)
edgewise_mutant(tail_of_too_few probes/error.hpp [[if (known >= least_for_p999)]] [[if (!answers.empty())]]
    Error.HasQuantiles* ${unit}/probes/known_numbers_test.cpp)

# Files of results
edgewise_mutant(formulas_are_left_alone reports/results/main_figures.cpp [["=+-@\t\r\n'"]] [["=+@\t\r\n'"]]
    CsvRow.* ${unit}/reports/results_test.cpp)
edgewise_mutant(breakdowns_are_columns reports/results/main_figures.cpp [[if (::fnmatch(pattern.c_str(), key.c_str(), 0) == 0)]] [[if (key.starts_with(pattern.substr(0, pattern.find('*'))))]]
    WideResults.* ${unit}/reports/results_test.cpp)
edgewise_mutant(policies_are_columns reports/results/main_figures.cpp [[if (key.find('/') != std::string::npos) return std::nullopt;]] [[]]
    WideResults.Leave* ${unit}/reports/results_test.cpp)

edgewise_mutant(commands_of_other_builds reports/page/pictures.cpp [[if (build == data.build.id)]] [[]]
    Report.HasThePoints* ${unit}/reports/report_paper_charts_test.cpp)

# Store
edgewise_mutant(old_figures_stay store/store.cpp [[delete from figure where build = ? and hash = ?]] [[delete from figure where build = ? and hash = ? and 0]]
    StoreTest.* ${unit}/store/store_test.cpp)
edgewise_mutant(failed_writes_stay store/sqlite.cpp [["rollback", nullptr]] [["commit", nullptr]]
    StoreTest.* ${unit}/store/store_test.cpp)

# Layouts of other libraries
edgewise_mutant(block_climb_takes_another_lanes_point algorithms/support.hpp [[best = {block.vertex(lane), block.point(lane), heights[lane]};]]
    [[best = {block.vertex(lane), block.point(7 - lane), heights[lane]};]] FieldLayouts.Climb* ${unit}/layout_parts/field_layouts_test.cpp)
edgewise_mutant(long_rings_end_at_their_first_block layouts/ring_block.hpp [[return vertex & more ? at(vertex & ~more, 0) : Place{block, lane, vertex};]]
    [[return Place{block, lane, vertex & ~more};]] FieldLayouts.Keep* ${unit}/layout_parts/field_layouts_test.cpp)
edgewise_mutant(level_sides_of_boxes_overlooked layouts/box.hpp [[== top) best ^= axis;]] [[> top) best ^= axis;]]
    Box.Finds* ${unit}/layout_parts/box_test.cpp)

# Raw V-Clip
edgewise_mutant(raw_vclip_asks_gjk algorithms/vclip.hpp [[body_b, observer, options.hardened, first);]] [[body_b, observer, true, first);]]
    RawWalk.* ${unit}/algorithms/raw_walk_test.cpp)
edgewise_mutant(hardened_vclip_is_raw algorithms/vclip.hpp [[body_b, nobody, true, first);]] [[body_b, nobody, false, first);]]
    RawWalk.* ${unit}/algorithms/raw_walk_test.cpp)
edgewise_mutant(wrong_distances_are_no_wrong_answers studies/stability/stability_tally.cpp [[+= checked.wrong();]] [[+= checked.verdict_wrong;]]
    StabilityTally.AWrongDistance* ${unit}/studies/stability_tally_test.cpp)

# Figure 8
edgewise_mutant(first_uses_are_misses studies/thrash/memory_demand.cpp [[curve.misses(size) - curve.firsts()]] [[curve.misses(size)]]
    ThrashDemand.* ${unit}/studies/thrash_test.cpp)
edgewise_mutant(faults_cost_nothing studies/thrash/factorial.cpp [[page_faults(scene, setting.memory_bytes) * setting.fault_ns + mechanism_ns]] [[mechanism_ns]]
    ThrashTime.* ${unit}/studies/thrash_test.cpp)
edgewise_mutant(gjk_may_be_as_erratic studies/thrash/factorial.cpp [[found.fall >= least_fall && found.gjk_fall < least_fall]] [[found.fall >= least_fall]]
    Figure8Facts.* ${unit}/studies/thrash_test.cpp)

# Campaign
set(campaign ${unit}/studies/campaign)
edgewise_mutant(proofs_round_the_wrong_way truth/filter/posed_pair.cpp [[height - rounding * (1 + 16 * u)]] [[height + rounding * (1 + 16 * u)]]
    FloatProof.SaysNothingFalse* ${campaign}/float_proof_test.cpp)
edgewise_mutant(corners_are_where_they_seem truth/filter/float_proof.cpp [[return v > certain;]] [[return v > 0;]]
    Enclosure.* ${unit}/truth/enclosure_test.cpp)
edgewise_mutant(any_answer_is_proven truth/checked_answer.cpp [[if (!(checked.worst_beyond() <= allowed.distance)) return std::nullopt;]] [[]]
    Campaign.FindsALiar* ${campaign}/campaign_test.cpp)
# Fields that travel together
edgewise_mutant(records_of_any_kind_are_one studies/fields/fields.cpp [[kind_[field.field] << 40 |]] [[]]
    CoAccess.* ${unit}/studies/fields_test.cpp)
edgewise_mutant(steps_that_read_nothing_count studies/fields/fields.cpp [[if (of_step_ == 0) return;]] [[]]
    CoAccess.* ${unit}/studies/fields_test.cpp)
edgewise_mutant(worst_groups studies/fields/best_groups.cpp [[if (cost < best[set]) {]] [[if (best[set] < cost) {]]
    BestGroups.AreAs* ${unit}/studies/fields_test.cpp)
edgewise_mutant(unread_fields_travel_along studies/fields/best_groups.cpp [[(reads.read() >> field & 1) != 0]] [[true]]
    BestGroups.FieldsThat* ${unit}/studies/fields_test.cpp)
edgewise_mutant(caches_of_pairs_stay_where_they_were studies/fields/field_trace.cpp [[access.address += is - was;]] [[]]
    FieldPlaces.OfAny* ${unit}/studies/fields_test.cpp)
edgewise_mutant(any_faster_median_holds studies/fields/fields.cpp [[if (time->high < std::min(1.0, noise->low))]] [[if (time->middle < 1)]]
    FieldsAdvice.* ${unit}/studies/fields_test.cpp)

# Many scales
edgewise_mutant(one_factor_for_two_axes table/scaled_table.hpp [[scale_.y() * point.y()]] [[scale_.x() * point.y()]]
    ScaledTable.Answers* ${unit}/algorithms/scaled_table_test.cpp)
