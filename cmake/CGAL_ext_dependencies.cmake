# What the headers need. Used by the build and by the installed package alike: the CGAL::*_support targets are made by
# these includes, not by find_package.
find_package(CGAL 5.5 REQUIRED)
find_package(Eigen3 3.4 REQUIRED)
include(CGAL_Eigen3_support)
find_package(Threads REQUIRED)
