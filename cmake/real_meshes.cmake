# Unpacks the meshes of Debian's package libcgal-demo into <build>/data, once, and names their folder
# CGAL_EXT_MESHES. Without the package the folder is missing, and what needs a real mesh says so.
set(archive /usr/share/doc/libcgal-dev/data.tar.gz)
set(CGAL_EXT_MESHES ${PROJECT_BINARY_DIR}/data/meshes)
if(NOT EXISTS ${CGAL_EXT_MESHES} AND EXISTS ${archive})
  message(STATUS "Unpacking the meshes of libcgal-demo")
  file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${PROJECT_BINARY_DIR} PATTERNS data/meshes/*)
endif()
if(NOT EXISTS ${CGAL_EXT_MESHES})
  message(STATUS "NOTICE: no real meshes: Debian's package libcgal-demo is not installed")
endif()
