// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_MINIMIZER_NUMBERS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_MINIMIZER_NUMBERS_H

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL_ext {
namespace internal {

/// the numbers of the two minimizers that no option sets, each with its unit, why it is as it is, and what another
/// value does. Dimensionless unless a unit is named. The numbers that users choose stand in `Balanced_minimization` and
/// `Stretch_minimization`.
struct Minimizer_numbers
{
  // --- the coarse patches: Patch_sequence, Patch_coarsener, is_good_replacement() ---

  /// interior vertices of a patch that is coarse enough: so few that its first map has no tiny triangles. More: a start
  /// that is nearer to the fine map, but may be lost in rounding.
  static constexpr int COARSEST = 8;

  /// vertices above which a coarse border is worth its trouble. Less: small patches lose border vertices, too, though
  /// they cost little as they are.
  static constexpr int LARGE = 2000;

  /// share of the vertices that a coarser patch is to lack (half of those that can be removed, or an eighth), of which it
  /// must lack so many. Less: many patches that are hardly coarser than the ones before.
  static constexpr double LEAST_REMOVED = 0.4;

  /// vertices of a patch per vertex that the next coarser one lacks, at most. More: dozens of patches that are as large as
  /// each other where most vertices are on the border.
  static constexpr int LARGEST_PART_KEPT = 16;

  /// border vertices per interior vertex from which on the border is made coarse, too: what is half border cannot be
  /// halved otherwise
  static constexpr double LARGEST_BORDER = 0.5;

  /// waves in which vertices at the rims of fans of more than `LARGEST_FAN` triangles are put back, at most, where the border is
  /// larger than that. More: such fans, as polygons have them, lose vertex after vertex of their rims, and to put these back
  /// makes triangle after triangle thinner, until they are lost in rounding. Less: more patches.
  static constexpr int MOST_WAVES = 6;
  static constexpr std::size_t LARGEST_FAN = 32;

  /// waves in which any vertices are put back where a patch, of no polygon, is made coarse in small steps, at most. More: long
  /// hairs with shorter edges at their tips lose one vertex after the other there, in 39 waves of one, and their maps are lost in
  /// rounding. Few waves of halves, too: maps that are none the worse for many change, and cuts with them.
  static constexpr int MOST_WAVES_OF_GRADUAL = 12;

  /// vertices of the mesh from which on there are so few waves, unless it is made coarse in small steps. Less: the first map of
  /// combs of a hundred teeth is not lost, but worse than those of other corners, which are tried when it is.
  static constexpr int LEAST_OF_FEW_WAVES = 2500;

  /// border vertices that are left in any case: the four corners need room between them
  static constexpr int LEAST_BORDER = 32;

  /// triangles round a vertex above which it is not removed: to walk round it takes time with their square, and again
  /// whenever one of its neighbors goes
  static constexpr std::size_t LARGEST_STAR = 100;

  /// share of its shape (height over longest side) that a triangle keeps when a vertex is removed, where that allows a
  /// coarser patch. Larger: better coarse triangles, and fewer vertices that can go.
  static constexpr double SHAPE_KEPT = 0.7;

  /// the same where it does not: thin protrusions cannot be shortened without thinner triangles. Larger: patches with
  /// protrusions stop getting coarser early.
  static constexpr double LEAST_SHAPE_KEPT = 0.05;

  /// cosine of the angle by which the normal of a triangle may turn when a vertex is removed: 60 degrees. Larger: flatter
  /// coarse patches that are less coarse.
  static constexpr double LEAST_NORMAL_COSINE = 0.5;

  /// height over longest side (an equilateral triangle has 0.87) above which any triangle is good
  static constexpr double GOOD_SHAPE = 0.15;

  /// vertices of a block of a large patch, in which one thread makes it coarse. Less: more vertices between the blocks, which
  /// wait. More: blocks that are not enough for all threads.
  static constexpr int VERTICES_COARSENED_AT_A_TIME = 8192;

  /// share of the vertices that are still to be removed, at most, which are removed in such blocks, twice. Larger: some that would
  /// not be removed if they were compared with all others.
  static constexpr double SHARE_COARSENED_IN_BLOCKS = 0.8;

  // --- what threads share: Patch_division ---

  /// vertices of a block, of which each thread takes one at a time. Less: more vertices between the blocks, which are
  /// visited last. More: blocks that are not enough for all threads on coarse patches.
  static constexpr int VERTICES_PER_BLOCK = 2048;

  // --- putting vertices back: Vertex_insertion ---

  /// steps that a vertex takes to its place: Newton's method settles one vertex in a few. More: slower, to the same map.
  static constexpr int INSERTION_STEPS = 8;

  /// share of the length between its neighbors by which a border vertex is at least away from either, to begin with
  static constexpr double LEAST_SHARE_OF_SIDE = 0.1;

  /// halvings of its distance from the neighbor that sees all of its ring: at 2^-50 rounding is reached
  static constexpr int MAXIMUM_INSERTION_HALVINGS = 50;

  // --- one vertex: Vertex_star ---

  /// share of the way to the first triangle without area that a vertex may go. Nearer to 1: longer steps that end in
  /// thinner triangles, where the next ones are short.
  static constexpr double STAR_SAFETY = 0.8;

  /// decrease of the energy promised by the step, relative to the energy of the star, below which the vertex stays: what
  /// rounding leaves of it is noise
  static constexpr double STAR_NEGLIGIBLE = 1e-12;

  /// halvings of a step of one vertex. More: vertices move that hardly gain by it; the next sweep visits them anyway.
  static constexpr int MAXIMUM_STAR_HALVINGS = 4;

  /// least eigenvalue of the Hessian of a star, as a share of the largest, that is taken as it is; a lower one, or a
  /// negative one, is replaced by `EIGENVALUE_SHIFT` times the largest, for steps along it would be wild
  static constexpr double LEAST_EIGENVALUE_RATIO = 1e-3;
  static constexpr double EIGENVALUE_SHIFT = 0.05;

  /// share of the promised decrease that a step must bring (Armijo's rule; Nocedal and Wright, section 3.1, where 1e-4
  /// is the usual value), of one vertex and of the whole map
  static constexpr double SUFFICIENT_DECREASE = 1e-4;

  // --- the whole map: Balanced_minimizer ---

  /// decrease of the energy by a sweep, relative, below which an interpolated map is smooth enough to be minimised. Less:
  /// sweeps that gain less than the minimizer would in the same time.
  static constexpr double LEAST_SWEEP_GAIN = 2e-3;

  /// sweeps over an interpolated map at most: a bound on the time; large errors need the mesh to move as a whole
  static constexpr int MAXIMUM_SWEEPS = 100;

  /// sweeps over the map that is delivered, which mend tiny triangles that the energy hardly sees
  static constexpr int SETTLING_SWEEPS = 5;

  /// pairs that L-BFGS remembers (Nocedal and Wright, section 7.2, say 3 to 20). More: memory and time per step.
  static constexpr std::size_t SECANT_PAIRS = 8;

  /// cosine of the angle between a step and the change of the gradient, at least, of a pair that is remembered: below,
  /// the curvature is lost in rounding, and the inverse Hessian would not stay positive definite
  static constexpr double LEAST_CURVATURE_COSINE = 1e-10;

  /// steps that the factors of the Hessian serve: first `EARLY_LIFETIME`, after `EARLY_STEPS` steps `LATE_LIFETIME`, for
  /// far from the minimum the Hessian changes more from step to step. Longer: cheaper steps, and more of them.
  static constexpr unsigned int EARLY_STEPS = 8;
  static constexpr unsigned int EARLY_LIFETIME = 4;
  static constexpr unsigned int LATE_LIFETIME = 8;

  /// steps whose common decrease is compared with the tolerance: a single step may gain little by chance
  static constexpr std::size_t STEPS_COMPARED = 5;

  /// a longer run of steps, whose common decrease is compared with so many tolerances once a minimization has taken
  /// `MANY_STEPS`: maps that are stretched tens of times come nearer to their minima for hundreds of steps, ever more
  /// slowly. More tolerances: they end farther from it.
  static constexpr std::size_t LONG_RUN = 30;
  static constexpr std::size_t MANY_STEPS = 100;
  static constexpr double TOLERANCES_OF_LONG_RUN = 200;

  /// the same of a map that is delivered and stretched (see `STRETCHED`), after any number of steps. Fewer, as 500: strips take
  /// up to half as long again, for 0.1 to 0.9 % less stretch. Coarse maps, too: strips are stretched up to 1.3 % more.
  static constexpr double TOLERANCES_OF_STRETCHED = 1000;

  /// share of the way to the first triangle without area that a step may go; see `STAR_SAFETY`
  static constexpr double STEP_SAFETY = 0.9;

  /// halvings of a step: at 2^-40 the map no longer changes by more than rounding
  static constexpr int MAXIMUM_STEP_HALVINGS = 40;

  /// length of a step below which it goes round the triangles that keep it short: a step that is a fiftieth of what is
  /// wanted moves nothing but them. After `MANY_STEPS` it is divided by `growth_of_roundabouts()`. Larger: more
  /// factorizations, and steps that leave much to the sweep.
  static constexpr double BLOCKED_STEP = 0.02;

  /// energy from which on a map counts as stretched, ten times or more, and vertices of its patch, at least: see
  /// `Balanced_steps::factorize()`, and `TOLERANCES_OF_STRETCHED`. Less of either: coarse maps by which cuts and corners are
  /// compared change, for the worse as often as for the better; more vertices, as 700: a spiral of 8000 faces is stretched 0.5 % more.
  static constexpr double STRETCHED = 200;
  static constexpr int SMALLEST_STRETCHED = 500;

  static bool is_stretched(double energy, int vertices) { return energy > STRETCHED && vertices >= SMALLEST_STRETCHED; }

  /// directions that are tried to go round triangles: vertices that stay make others stand in the way
  static constexpr int MAXIMUM_ROUNDABOUTS = 4;

  /// how many times what a step promises a minimization may still gain. Less: borders are given up for others that are
  /// no better; more: what is clear is minimised further.
  static constexpr double MOST_PROMISES = 3;

  /// sweeps over a map that was carried over to a similar border, at most: its errors are at the border, and large
  static constexpr int SWEEPS_OF_TRANSPORTED = 2;

  /// cost of a step, as a multiple of that of a sweep; measured
  static constexpr long STEP_WORK = 4;

  /// the same of a direction that is tried to go round triangles, with the factors that are taken anew after it; times
  /// `growth_of_roundabouts()`
  static constexpr double ROUNDABOUT_WORK = 2;

  /// the same where the steps on a map that is delivered are counted: what it costs on sheets with nails and fins. If all maps
  /// counted it so, corners would not move on some surfaces that they suit.
  static constexpr double ROUNDABOUT_WORK_OF_DELIVERED = 3;

  /// the same, at least, in what the whole map counts for, where it ends above `LOST_RESULT`: triangles stand in the way of
  /// most of its steps, and other maps are worth more. Less: surfaces of a thousand faces take more than a second, in vain.
  static constexpr double ROUNDABOUT_WORK_OF_LOST = 6;

  /// vertices of a patch whose matrices are factored, at most: above, a V-cycle over the coarser patches stands for the
  /// factors, whose time and memory grow faster than the patch
  static constexpr int LARGEST_FACTORED = 20000;

  /// times that it costs more to go round triangles of a patch than of one with `SMALL_FACTORED` vertices or fewer: the square
  /// root of the vertices, for so much faster does the time of factors grow than that of sweeps
  static constexpr int SMALL_FACTORED = 300;
  static double growth_of_roundabouts(int vertices)
  {
    return std::sqrt(double((std::clamp)(vertices, SMALL_FACTORED, LARGEST_FACTORED)) / SMALL_FACTORED);
  }

  /// edges from a vertex to the border, at most, of a patch that is factored however large it is. Less: polygons and strips
  /// of tens of thousands of corners, whose thin triangles no V-cycle reaches, are left far from their minimum. More: factors
  /// of patches that are not narrow.
  static constexpr int LARGEST_DEPTH_FACTORED = 4;

  // --- from coarse to fine: Multilevel_minimizer, Minimizer_levels and Coarse_to_fine_descent ---

  /// balance of coarse patches, at least: pure L2 stretch tears coarse maps open elsewhere than fine ones, and a little
  /// balance keeps them alike
  static constexpr double LEAST_COARSE_BALANCE = 0.1;

  /// tolerance of coarse patches, relative: there saddle points, as symmetric meshes have them, are left at little cost.
  /// Larger: some maps stay at a saddle point.
  static constexpr double COARSE_TOLERANCE = 1e-5;

  /// steps on a coarse patch at most: a bound on the time. Most patches need fewer than 20; more than this is spent where
  /// a map is stretched tens of times, and hardly changes the map of the finer patch.
  static constexpr unsigned int COARSE_ITERATIONS = 60;

  /// the same on a coarse patch that begins with the map of one with hardly fewer vertices: with `LEAST_REFINED` or more,
  /// and more than a `SMALL_REFINEMENT`-th of its own. More: surfaces with ears and spikes, of which many such patches are
  /// made, take seconds; fewer: their maps are stretched more.
  static constexpr unsigned int ITERATIONS_OF_SMALL_REFINEMENT = 10;
  static constexpr double SMALL_REFINEMENT = 1.2;
  static constexpr int LEAST_REFINED = 1000;

  /// the same once a map has cost too much, and is hopeless: polygons with thousands of spikes take seconds for a map that is
  /// stretched thousands of times, or tens of thousands
  static constexpr unsigned int ITERATIONS_OF_LOST_MAP = 10;

  /// what a hopeless map may cost until then, in sweeps over the mesh; or in vertices visited, where that is more. Less:
  /// surfaces whose maps are led out of a stretch of hundreds in the end are given few steps; more: surfaces of a thousand
  /// faces take more than a second, in vain. At most what the steps on the delivered map may cost (`MOST_FINAL_SWEEPS`).
  static constexpr long MOST_HOPELESS_SWEEPS = 1000;
  static constexpr long LEAST_HOPELESS_WORK = 1000000;

  /// steps on the mesh itself at most while candidates for the corners are compared: a bound on the time. Fewer: maps
  /// stretched tens of times are compared before they are comparable.
  static constexpr unsigned int SEARCH_ITERATIONS = 60;

  /// cost of the steps on the map that is delivered, in sweeps over the mesh, after which there are no more; a mesh that has
  /// fewer than `FINAL_VERTICES` counts as if it had as many. What several starts have cost, or one that is hopeless, is
  /// taken off, but for a quarter. Less: maps stretched tens of times are left before they are near their minimum.
  static constexpr long MOST_FINAL_SWEEPS = 350;
  static constexpr int FINAL_VERTICES = 20000;

  /// the same for each vertex beyond these, of a map that is not hopeless by then: long strips and polygons take hundreds of
  /// steps that lower their energy by a thousandth in all. Less: strips of ten thousand cells and more are stretched more, by
  /// 0.8 % at most as it is.
  static constexpr long MOST_FINAL_SWEEPS_OF_MORE = 80;

  /// times all that, at most, for a map that is not hopeless by `HOPELESS_RESULT`, and of which the energy has fallen by the
  /// share `FAST_FALL` in its last `LONG_RUN` of steps: small surfaces with spikes and polygons split between their corners
  /// come down from a stretch of hundreds to one of tens so. A lower share, as 0.003: a thing with fins takes a quarter
  /// longer, to be stretched 0.7 % less.
  static constexpr long MOST_TIMES_WORK = 3;
  static constexpr double FAST_FALL = 0.01;

  /// times as many vertices as it has that a mesh of fewer than `FINAL_VERTICES` counts for, at most; a quarter of these it counts
  /// for in any case. More: closed surfaces of a thousand faces with spikes, which take all steps that they are given, take
  /// more than a second.
  static constexpr int MOST_TIMES_FINAL_VERTICES = 12;

  /// vertices of the patch whose maps are warm starts, at most: above, to transport a map costs more than it saves
  static constexpr int LARGEST_WARM_START = 1000;

  /// vertices of the patch that is sketched, at most: enough to tell borders apart
  static constexpr int LARGEST_SKETCH = 2000;

  /// vertices of the patch of rough maps, on which corners are moved, at most: hundreds are compared
  static constexpr int LARGEST_ROUGH = 300;

  /// interior vertices, at most, of one that has up to twice as many vertices, most of them on the border: with a few
  /// dozen inside, maps of such a patch compare corners otherwise than those of all finer ones
  static constexpr int LARGEST_ROUGH_INTERIOR = 200;

  /// vertices of patches on which corners are moved twice, first on one with `SHARE_OF_FIRST_MOVES` of the vertices, and then, as
  /// on sketches, on the patch itself; at most a `LEAST_PER_BORDER_VERTEX`-th is on the border. Smaller ones, and those with
  /// more border, are not compared well by coarser ones. Larger ones: more time.
  static constexpr int LEAST_MOVED_TWICE = 200, MOST_MOVED_TWICE = 700;
  static constexpr int LEAST_PER_BORDER_VERTEX = 4;

  /// Larger: more time for the same corners. Less, as 0.3: worse corners.
  static constexpr double SHARE_OF_FIRST_MOVES = 0.35;

  static constexpr bool moves_corners_twice(int vertices, int border_vertices)
  {
    return vertices >= LEAST_MOVED_TWICE && vertices <= MOST_MOVED_TWICE &&
           LEAST_PER_BORDER_VERTEX * border_vertices <= vertices;
  }

  /// vertices from which on a patch is sketched. More: closed surfaces and strips of 7500 vertices take a third longer, for the
  /// same maps; fewer, as 5000: strips are stretched up to 2 % more, and other surfaces 0.1 %.
  static constexpr int SMALLEST_SKETCHED = 7000;

  /// vertices of a patch per vertex of its sketch, at least: else a sketch saves little
  static constexpr int LEAST_SKETCH_RATIO = 4;

  /// energy of a coarse map above which another start is tried: a map with a stretch of a hundred is hardly ever led out
  /// of it
  static constexpr double HOPELESS = 1e4;

  /// energy of a costly sketch above which others are not worth their time: they are stretched alike
  static constexpr double HOPELESS_SKETCH = 2e3;

  /// energy of a map that is to be delivered above which other starts are tried where they cost little: a stretch of some
  /// hundred. Less: surfaces that are stretched a hundred times whatever one does are mapped four times; more: some that are
  /// stretched ten times from another start are stretched hundreds of times.
  static constexpr double POOR_RESULT = 2e5;

  /// the same where they cost much; and above which there is little hope that more work on a map, or on its corners, pays: a
  /// stretch of the order of a thousand
  static constexpr double HOPELESS_RESULT = 1e6;

  /// energy of a map that is compared, above which it stays above `POOR_RESULT` however long it is minimised: other
  /// starts are tried before. Less: a map that would do is left for one that is a little worse.
  static constexpr double LOST_RESULT = 1e9;

  /// relative difference of two energies, at most, at which another start has led to the same poor map: no more are
  /// tried. Less: surfaces of a thousand faces take more than a second, in vain.
  static constexpr double AGREEMENT_OF_STARTS = 0.02;

  /// share of the vertices of the patch to be mapped, below which a coarse patch may be given up for its energy: of
  /// later ones most of the work is done. Larger: work on polygons of ten thousand corners is thrown away.
  static constexpr double LARGEST_GIVEN_UP = 0.2;

  // --- the iteration of Yoshizawa et al.: Stretch_iteration, Flip_repair ---

  /// the exponents of the first iterations are its powers, where these are larger than eta: the first maps are far from
  /// their limit, and long steps save a quarter of the iterations. Nearer to 1: longer steps for more iterations.
  static constexpr double FIRST_EXPONENT = 0.7;

  /// sweeps over flat or flipped triangles at most: a bound on the time
  static constexpr int MAXIMUM_REPAIR_SWEEPS = 48;

  /// sweeps after which one more ring of vertices round these triangles moves: what a ring has no room for needs the next
  static constexpr int REPAIR_SWEEPS_PER_RING = 4;

  /// triangles round a vertex for which to cut its kernel, of up to as many corners, counts for as much as to look at them. Fewer:
  /// cuts of small surfaces with fans of some dozen triangles are grown less, and these are stretched more; more: double fans of
  /// thousands that have no map take longer to be refused.
  static constexpr long TRIANGLES_OF_COSTLY_KERNEL = 150;

  /// flat or flipped triangles for each sweep that is left, and for each of so many of all triangles, at most: sweeps over more are
  /// in vain. Of 16000 repairs of random surfaces none of the 14000 that succeed has as many after `REPAIR_SWEEPS_PER_RING`
  /// sweeps. Fewer: maps are given up that can be repaired; more: closed surfaces that have no map take twice as long to be
  /// refused.
  static constexpr double most_repaired_in_sweep(std::size_t triangles)
  {
    return (std::max)(8., 1e-3 * double(triangles));
  }
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_MINIMIZER_NUMBERS_H
