/*!
\ingroup PkgSquareParameterizationConcepts
\cgalConcept

The concept `CornerSearch` describes the requirements for a strategy that looks for the best corners of the square. A
strategy knows no geometry: it asks for the objective of candidates, and the best of all candidates that it asked for is
the result. It can thus be tested on an array of numbers.

\cgalRefines{`CopyConstructible`}

\cgalHasModelsBegin
\cgalHasModels{`CGAL_ext::Brute_force_corner_search`}
\cgalHasModels{`CGAL_ext::Quarter_brute_force_corner_search`}
\cgalHasModels{`CGAL_ext::Step_sampling_corner_search`}
\cgalHasModels{`CGAL_ext::Single_highest_corner_search`}
\cgalHasModels{`CGAL_ext::Many_high_corner_search`}
\cgalHasModels{`CGAL_ext::Better_of_two_corner_search`}
\cgalHasModels{`CGAL_ext::Hybrid_corner_search`}
\cgalHasModels{`CGAL_ext::Particle_swarm_corner_search`}
\cgalHasModels{`CGAL_ext::First_candidate_corner_search`}
\cgalHasModels{`CGAL_ext::Corner_search`, which holds any of them}
\cgalHasModelsEnd

\sa `CGAL_ext::Corner_search_problem`
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
  `problem` help it to choose. Candidates that are asked for in one
  call are mapped concurrently; a candidate that was asked for before costs nothing.

  Its choices must depend on the answers alone, not on time or on threads: then the result is the same for any number of
  threads.

  \pre `problem.number_of_candidates` is at least 1
  */
  void operator()(const CGAL_ext::Corner_search_problem& problem) const;
};
