/*!
\ingroup PkgSquareParameterizationConcepts
\cgalConcept

The concept `CornerSearch` describes the requirements for a strategy that looks for the best corners of the square. A
strategy knows no geometry: it asks for the objective of candidates, and the best of all candidates that it asked for is
the result. It can thus be tested on an array of numbers. A strategy of your own is given to
`Square_border_corner_search_parameterizer_3`, for CGAL's function `%parameterize()`, or to `parameterize_onto_square()`.

A model that has numbers may have, in addition, a function `bool is_valid() const` that says whether they are in their
ranges: a search with one that is not is refused with `ERROR_WRONG_PARAMETER` before anything is mapped.

\cgalRefines{`CopyConstructible`}

\cgalHasModelsBegin
\cgalHasModels{`CGAL_ext::Brute_force_corner_search`}
\cgalHasModels{`CGAL_ext::Quarter_brute_force_corner_search`}
\cgalHasModels{`CGAL_ext::Step_sampling_corner_search`}
\cgalHasModels{`CGAL_ext::Single_highest_corner_search`}
\cgalHasModels{`CGAL_ext::Many_high_corner_search`}
\cgalHasModels{`CGAL_ext::Better_of_two_corner_search`}
\cgalHasModels{`CGAL_ext::Hybrid_corner_search`}
\cgalHasModels{`CGAL_ext::Bracketing_corner_search`, the default of `parameterize_onto_square()`}
\cgalHasModels{`CGAL_ext::Particle_swarm_corner_search`}
\cgalHasModels{`CGAL_ext::First_candidate_corner_search`}
\cgalHasModels{`CGAL_ext::Corner_search`, which holds any of them}
\cgalHasModelsEnd

\sa `CGAL_ext::Corner_search_problem`
\sa `CGAL_ext::Square_border_corner_search_parameterizer_3`
\sa `CGAL_ext::parameterize_onto_square()`
*/
class CornerSearch
{
public:
  /*!
  returns the set of border vertices to choose from: all of them, or those of the first quarter.
  */
  CGAL_ext::Candidate_set candidate_set() const;

  /*!
  asks `problem.objective_of()` for the objective of at least one candidate, as often as it likes. The other members of
  `problem` help it to choose. Candidates that are asked for in one call are mapped concurrently; a candidate that was
  asked for before costs nothing, and an empty batch is allowed.

  Its choices must depend on the answers alone, not on time or on threads: then the result is the same for any number of
  threads. It is called once per map, by one thread; for maps that are made at the same time, at the same time on copies
  or on one object.

  The functions of `problem` leave it by an exception in two cases. When the search is cancelled, what is thrown is not
  derived from `std::exception`, and the best candidate so far is the result. When a candidate does not exist, or the
  strategy ends without having asked for any, `%parameterize()` returns `ERROR_WRONG_PARAMETER`, and
  `parameterize_onto_square()` names the candidate in its message. A strategy lets these exceptions through, so that what
  it holds must be released by destructors, and it cannot rely on reaching its last line. An exception of its own comes
  out of `%parameterize()`.

  \pre `problem.number_of_candidates` is at least 1; this is always so.
  \pre Every candidate it asks for, also for its corner distances, is in [0, `problem.number_of_candidates`[; others are
       refused as said above.
  */
  void operator()(const CGAL_ext::Corner_search_problem& problem) const;
};
