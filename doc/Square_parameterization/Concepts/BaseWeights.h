/*!
\ingroup PkgSquareParameterizationConcepts
\cgalConcept

The concept `BaseWeights` describes the requirements for the weights with which the interior of a disk is first mapped.
They are the weights \f$ w_{ij} \f$ of the linear system of Section \ref SquareParameterizationIteration.

With positive weights the map is one-to-one. Weights may be negative or zero: a candidate whose map is not one-to-one is
discarded. With weights that are symmetric in addition, \f$ w_{ij} = w_{ji} \f$, the
systems are solved by a sparse Cholesky factorization, which is faster than the LU factorization of the general case.

\cgalRefines{`CopyConstructible`}

\cgalHasModelsBegin
\cgalHasModels{`CGAL_ext::Blended_weights`}
\cgalHasModels{`CGAL_ext::Clamped_cotangent_weights`}
\cgalHasModels{`CGAL_ext::Uniform_weights`}
\cgalHasModels{`CGAL_ext::Mean_value_weights`}
\cgalHasModels{`CGAL_ext::Symmetric_mean_value_weights`}
\cgalHasModels{`CGAL_ext::Shape_preserving_weights`}
\cgalHasModels{`CGAL_ext::Harmonic_weights`}
\cgalHasModelsEnd

\sa `CGAL_ext::Patch`
\sa `CGAL_ext::Edge_weights`
\sa `CGAL_ext::Stretch_minimizing_parameterizer_3`
\sa `CGAL_ext::Stretch_minimization`
*/
class BaseWeights
{
public:
  /*!
  returns two weights for every edge of `patch`, one for the equation of each of its ends, and says whether they are
  symmetric. The disk is given as flat arrays of points, triangles and edges, scaled to area 1. Thus, for weights that
  are the inverse lengths of the edges:
  \code{.cpp}
  CGAL_ext::Edge_weights weights(patch, 0, true); // as many as there are edges, symmetric
  for(std::size_t e = 0; e < patch.edges.size(); ++e) {
    const double length = (patch.points[patch.edges[e][0]] - patch.points[patch.edges[e][1]]).norm();
    weights.values[e] = {1 / length, 1 / length};
  }
  return weights;
  \endcode

  It is called once, or a few times, for the disk that is mapped, and, where a minimizer works from coarse to fine or
  cuts are compared, for disks made of it; for several of these at the same time, on one object. The result must depend
  on the disk alone.

  What it throws comes out of `%parameterize()`. Weights that are not two for each edge, or that are said to be symmetric
  and are not, are refused with `ERROR_WRONG_PARAMETER`; with weights that are not finite there is no map.

  Complexity: should be linear in the number of faces.
  */
  CGAL_ext::Edge_weights operator()(const CGAL_ext::Patch& patch) const;
};
