# `cpack -G DEB` in the build folder makes amontons_*.deb (the program) and libamontons-dev_*.deb (the library). Configured by
# `cmake --preset package` they run on every amd64; with AVX2 their version, their name and their description say that they need it.
set(CPACK_PACKAGE_NAME amontons)
set(CPACK_PACKAGE_VENDOR Amontons)
# The maintainers have no common address (AUTHORS): who publishes a package is to say "NAME <ADDRESS>" here.
set(AMONTONS_PACKAGE_CONTACT "The maintainers of Amontons" CACHE STRING "Maintainer of the Debian packages, NAME <ADDRESS>")
set(CPACK_PACKAGE_CONTACT "${AMONTONS_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "contact between elastic bodies, with friction")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program library)
set(CPACK_DEBIAN_PACKAGE_VERSION ${PROJECT_VERSION})
set(AMONTONS_NEEDS "It runs on every processor of this architecture.")
if(AMONTONS_AVX2)
  string(APPEND CPACK_DEBIAN_PACKAGE_VERSION "+avx2")
  set(AMONTONS_NEEDS "This build needs a processor with AVX2 (x86-64-v3).")
endif()

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME amontons)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Without gmsh no .geo and no binary .msh is read; gnuplot draws the charts of studies; mpirun starts several ranks.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "gmsh, gnuplot-nox | gnuplot, openmpi-bin, libopenblas0-pthread")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "paraview, libamontons-dev")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
  "Computes where elastic bodies touch, how hard they press, and where they\n\
stick or slip, to a tolerance that is asked for. A scene is a short text file;\n\
scenes and meshes are in /usr/share/amontons/parameters.\n\
${AMONTONS_NEEDS}")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libamontons-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
# One deal.II: the library is static and made of its templates.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
  "amontons (= ${CPACK_DEBIAN_PACKAGE_VERSION}), libdeal.ii-dev (>= ${DEAL_II_PACKAGE_VERSION}), g++, cmake")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
  "The program amontons as a static library, for find_package(Amontons) in\n\
CMake.\n\
${AMONTONS_NEEDS}")
# What Debian asks of each package: changes in its own format, compressed.
string(TIMESTAMP AMONTONS_PACKAGE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(package amontons libamontons-dev)
  set(changelog ${CMAKE_BINARY_DIR}/packaging/${package}/changelog)
  file(WRITE ${changelog} "${package} (${CPACK_DEBIAN_PACKAGE_VERSION}) unstable; urgency=medium\n\n  * See /usr/share/doc/amontons/CHANGELOG.md.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${AMONTONS_PACKAGE_DATE}\n")
  execute_process(COMMAND gzip -9nf ${changelog})
  string(REPLACE libamontons-dev library part ${package})
  string(REPLACE amontons program part ${part})
  install(FILES packaging/copyright ${changelog}.gz DESTINATION share/doc/${package} COMPONENT ${part})
endforeach()
include(CPack)
