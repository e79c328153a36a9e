// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_NUMBERS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_NUMBERS_H

namespace CGAL_ext {
namespace internal {

/// the tuned numbers of the decision on a cut. None changes what is correct: whatever they are, a cut leaves a disk.
/// They trade the score of the cut, which is the L2 stretch that is left plus the weighted length, for time; the
/// benchmark `cut_defaults` varies each and prints what becomes of both.
///
/// `A map` below is that of one cut for one choice of corners, by which the cut is scored.
struct Cut_numbers
{
  // --- simplified copies, on which cuts are found ---

  /// faces of the copy on which cuts are compared at last. More: the stretch of short cuts is overrated less, and every
  /// score takes longer.
  int decision_faces = 4000;

  /// faces of the copy on which cuts are grown at last, by dozens of scores: with the simpler copies, most of the time
  /// goes there. Fewer: the copy loses the features for which a cut is extended.
  int growth_faces = 800;

  /// still simpler copies, on each of which cuts are grown, too. Growth ends in one of many local minima: a copy that
  /// differs ends in another. More: a better cut here and there, for much time: with three the score falls by a tenth of a per
  /// cent, and the decision takes a fifth longer.
  int simpler_copies = 2;

  /// the same of a surface so small that no copy of `growth_faces` is made: cuts are grown on the surface itself, and
  /// less is left to be found. More: small surfaces take longer than large ones.
  int simpler_copies_of_small = 1;

  /// faces of the simplest of them; the others lie between it and `growth_faces`
  int simplest_growth_faces = 400;

  /// faces that a copy gets beyond the number aimed at for each hole, and two times for each handle: round each of them
  /// lie a dozen triangles at least. Fewer: the simplification cannot keep the topology, and there is no copy.
  int faces_per_loop = 12;

  /// times the faces aimed at: a surface that has no more is not simplified, since what is saved is less than what a
  /// copy costs in accuracy
  double least_reduction = 1.25;

  /// times the faces aimed at: of a surface that has more, short edges are collapsed first, in a fraction of the
  /// time of collapsing by shape alone
  double very_fine = 4;

  /// times the faces aimed at: where collapsing short edges ends, and collapsing by shape begins. Fewer is faster, and
  /// begins to cost shape. Less than `very_fine`.
  double still_fine = 2;

  // --- the score of a cut ---

  /// choices of corners, spread evenly over a quarter of the border, of which the best gets a map. Fewer: the
  /// score depends on where the cut happens to begin.
  int corner_candidates = 8;

  /// iterations of the stretch iteration by which these choices are compared, each one linear system for each choice.
  /// One tells good corners from bad ones; the minimizer does the rest.
  int start_iterations = 1;

  /// steps of the balanced minimizer in a score, at most. Most maps need half of them; a map that is not done is made
  /// from coarse to fine instead, since its stretch may be twice the least. Fewer: more cuts are scored that slow way.
  int score_steps = 100;

  /// of the cuts that compete, the best few by what the cheap iteration leaves, which get a map. Fewer: the best one is missed.
  int mapped = 6;

  /// relative decrease of the energy at which this map is done. Larger: as with fewer maps.
  double first_score_tolerance = 1e-1;

  /// the best few of these maps, which are lowered further
  int mapped_roughly = 4;

  /// relative decrease of the energy at which these are done, and the maps of all cuts to begin with: they bound the stretch
  /// from above. Larger: the best of the cuts that compete is missed.
  double rough_score_tolerance = 1e-2;

  /// the best few, by their rough scores, of the cuts that compete, which are scored well
  int scored_well = 3;

  /// the same of the cuts that growth begins with, as a share of those that are scored at a time; the others are compared by
  /// rough scores. More: a thirtieth of the time, for nothing.
  double starts_scored_well = 0.3;

  /// relative decrease of the energy at which the map of a good score is done. A score need not be better than the
  /// differences that it decides on.
  double score_tolerance = 1e-3;

  /// the same on the copy of `decision_faces`, where little is left that parts the cuts. Larger: surfaces that stretch
  /// much are cut at a wrong place by the noise of the scores.
  double decision_tolerance = 1e-4;

  /// sweeps over the map that the cheap iteration for one choice of corners counts for; measured
  long start_work = 2;

  /// times that a score visits each vertex, at most, for it to count as one map in the work below; half as many again
  /// as in the mean. One that visits them more often counts for more. Less: growth ends earlier where maps are slow.
  long ordinary_work = 80;

  // --- the cuts to begin with, on a closed surface with handles ---

  /// roots from which the shortest cut is sought, at most. The shortest is often not the best; more: more starts are
  /// scored.
  int most_roots = 12;

  /// roots however many handles there are
  int fewest_roots = 2;

  /// roots times handles, between these bounds: with many handles one cut is much like another, and slow to find
  int roots_times_handles = 120;

  // --- growth ---

  /// terminals that are added in one growth, at one weight, at most. A bound for cuts that keep paying; patience ends
  /// most growths.
  int most_additions = 10;

  /// terminals added, or dropped, in a row without a lower score, after which growth ends: two terminals may pay
  /// together where neither does alone
  int patience = 2;

  /// vertices farthest from the cut, and as many maxima of stretch, that compete to be the next terminal. Each costs a
  /// cheap iteration, and some a map.
  int candidates = 5;

  /// iterations of the map onto a circle that tells the maxima of stretch. It tells where the surface is long, for
  /// which it need not be the best.
  int circle_iterations = 5;

  /// vertices mapped in all scores of one copy, at all weights, at most. More: a better cut here and there, for much
  /// time.
  long growth_work = 120000;

  /// the same per vertex of the surface, where that is less: small surfaces are not grown for longer than large ones.
  /// Fewer: small surfaces get a little more stretch; more: they take seconds where their maps are slow.
  long growth_work_per_vertex = 150;

  /// the same per vertex of a surface so small that no copy of `growth_faces` is made. More: surfaces of a thousand faces
  /// take more than a second.
  long growth_work_of_small = 65;

  /// the same in the scores of the cuts that are carried over to the copy of `decision_faces`: several times what
  /// a dozen ordinary ones take. Fewer: a good cut is not met there, where maps are slow.
  long decision_work_per_vertex = 60;

  /// vertices that growth maps on one copy, at most, where the numbers per vertex make it less. Fewer: surfaces of less than
  /// two hundred faces, which take no time, get stretch that they need not have.
  long least_growth_work = 10000;

  /// times the work above, while no cut that was met has a map. Fewer: some surfaces of which hardly any cut has one have
  /// no map in the end; more: seconds of search in vain.
  long times_work_without_map = 5;

  /// the same on a surface of which no copy of `growth_faces` is made, as it is so small, nearly always. More: surfaces of some hundred faces that have no
  /// map take a second to be refused.
  long times_work_without_map_of_small = 2;

  /// L2 stretch that the best cut leaves above which growth on the last copy goes on for `times_growth_work`, but for no
  /// more than `long_growth_work`, where that is twice the usual work. Of such surfaces growth meets a much better cut now
  /// and then: L2 + 0.05 length of 15 of 394 random surfaces changed, and fell by 15 % in the geometric mean. More
  /// work: surfaces of a thousand faces take more than a second.
  double large_stretch = 10;
  long times_growth_work = 5;
  long long_growth_work = 40000;

  /// `growth_work` where there are many loops: see `many_loops`
  long little_growth_work = 35000;

  /// holes, and twice the handles: where there are as many, one cut is much like another, and one terminal more means
  /// nothing: growth gets little work
  int many_loops = 40;

  /// times that every terminal is tried elsewhere at the end of a growth, unless none moved the time before
  int move_rounds = 2;

  /// neighbors of a terminal where it is tried then, at most. More: a terminal on the apex of a large fan costs hundreds of
  /// cheap iterations.
  int most_neighbors = 12;

  // --- selection, and refinement ---

  /// good cuts of different lengths that are carried over to a finer copy
  int selected = 10;

  /// how far the stretch of a cut that is carried over may lie above the front of all cuts, relative
  double far = 0.05;

  /// places round a terminal, besides that along the cut, where it is tried. Each costs a map, nearly.
  int directions = 3;

  /// how far a terminal is moved at first, in units of sqrt(area): five edges of 4000 faces, two of 700
  double first_step = 0.12;

  /// how far it is moved at last, in units of sqrt(area): about an edge of 4000 faces, below which there is
  /// no other place. Steps are halved in between.
  double last_step = 0.03;

  /// vertices mapped to refine a cut for one weight, at most: nine cuts of a few hundred faces. Where a score costs more,
  /// as on the copy of `decision_faces`, nothing is refined. Four times as many vertices as there are instead: L2 + 0.05
  /// length of thirteen surfaces falls by a tenth of a per cent, for a fifth more time.
  long refinement_work = 1500;

  /// vertices mapped to refine a cut for a weight outside the family, where growth has come less far, at most: fifteen cuts of
  /// 4000 faces. Less: needles are not cut across where that is wanted.
  long refinement_work_outside = 30000;

  /// holes, and twice the handles, of a surface whose cuts are refined for the weights of the family, at most. More: a fifth of
  /// the time of surfaces of a thousand faces, for nothing in the mean.
  int most_loops_refined = 7;

  /// L2 stretch that a cut leaves, at most, for it to be refined; one that has no map is not. More: a third of a second,
  /// nearly always in vain.
  double largest_refined_stretch = 1000;

  /// L2 stretch that a cut leaves, at most, for it to be judged by searched corners. More: where there are spikes, whose maps
  /// take long, the corners are not what matters.
  double largest_judged_stretch = 10;

  /// how far the score of a cut may lie above that of the best with searched corners, relative, for it to be judged by these,
  /// too: they lower a score by 3 % at most. More: a tenth of a second for each cut, in vain.
  double far_from_best = 0.03;

  /// cuts that are judged so, at most, the best by their scores. More: a cow takes a tenth longer, for a cut that is no better.
  /// Fewer: one in a hundred surfaces is left with 0.5 % more.
  int most_judged = 3;

  // --- carrying a cut over to a finer surface, and two cuts that tie ---

  /// pieces of an edge of the cut, at whose ends the nearest vertices of the finer surface are sought: enough to lead
  /// along the edges of a surface that is a hundred times finer
  int lift_samples = 8;

  /// how far the cut may be rerouted on either side, in edges of the cut. More: it is shorter, but another way may
  /// leave more stretch than the cut that was chosen.
  double lift_band = 2;

  /// how far the score of a cut may lie above the best, relative, for it to be carried over and compared by its length
  /// there: lengths change by 2 % at most. More: a hundredth of a second for each cut, in vain.
  double near_best = 0.01;

  /// how far the score of a second cut may then lie above that of the best, relative, for both to be mapped: a copy tells what
  /// cuts leave to a few thousandths. Larger: more second maps, nearly all in vain.
  double tie = 0.0017;

  /// faces of a surface, at most, of which two cuts are mapped. More: surfaces of fifty thousand faces take half as long
  /// again, for a thousandth of L2 + 0.05 length.
  int largest_mapped_twice = 20000;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_NUMBERS_H
