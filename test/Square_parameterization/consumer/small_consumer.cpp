// Headers of CGAL_ext, Eigen and CGAL, and exact numbers of the libraries that CGAL links: compiled in a moment, with CMake and
// without.
#include <CGAL_ext/Square_parameterization/Grid_size.h>

#include <CGAL/Gmpq.h>

#include <Eigen/Core>

int main()
{
  const CGAL_ext::Grid_size size{3, 2};
  const CGAL::Gmpq third = CGAL::Gmpq(1) / CGAL::Gmpq(3);
  return size.is_valid() && third + third + third == 1 && Eigen::Vector2d(3, 4).norm() == 5 ? 0 : 1;
}
