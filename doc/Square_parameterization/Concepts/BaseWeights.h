/*!
\ingroup PkgSquareParameterizationConcepts
\cgalConcept

The concept `BaseWeights` describes the requirements for the weights with which the interior of a disk is first mapped.
They are the weights \f$ w_{ij} \f$ of the linear system of Section \ref SquareParameterizationIteration.

With positive weights the map is one-to-one. With weights that are symmetric in addition, \f$ w_{ij} = w_{ji} \f$, the
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

\sa `CGAL_ext::Stretch_minimizing_parameterizer_3`
\sa `CGAL_ext::Stretch_minimization`
*/
class BaseWeights
{
public:
  /*!
  returns two weights for every edge of `patch`, one for the equation of each of its ends, and says whether they are
  symmetric.

  The disk is given as flat arrays of points, triangles and edges, scaled to area 1. The types of the parameter and of
  the result belong to the namespace `CGAL_ext::internal`: their layout may change from one version to the next, and a
  model outside this package has to follow.

  Complexity: should be linear in the number of faces; it is called once per disk.
  */
  unspecified_type operator()(const unspecified_type& patch) const;
};
