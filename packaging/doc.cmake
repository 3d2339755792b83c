# `cmake --build build --target doc`: pages and headers as HTML in build/doc/html, by doxygen; formulas by MathJax, which is copied
# there, so that the pages need no network.
find_package(Doxygen QUIET)
set(AMONTONS_MATHJAX /usr/share/javascript/mathjax CACHE PATH "MathJax 2 (Debian: libjs-mathjax), for the target doc")
if(NOT DOXYGEN_FOUND OR NOT EXISTS ${AMONTONS_MATHJAX}/MathJax.js)
  set(DOXYGEN_FOUND FALSE)
  add_custom_target(doc COMMAND ${CMAKE_COMMAND} -E echo "The target doc needs doxygen and MathJax 2: ./setup.sh doxygen libjs-mathjax" COMMAND false)
  return()
endif()
file(GLOB AMONTONS_PICTURES CONFIGURE_DEPENDS doc/pictures/*.* doc/pictures/gallery/*)
list(JOIN AMONTONS_PICTURES " " AMONTONS_PICTURES)
# In the order in which they are read, the first one as the front page; what is not named here comes after them.
file(GLOB AMONTONS_OTHER_PAGES CONFIGURE_DEPENDS doc/*.md)
foreach(page tutorial walk introduction program results gallery scene_files studies targets models benchmarks failure_atlas scorecard install)
  list(APPEND AMONTONS_PAGES ${CMAKE_SOURCE_DIR}/doc/${page}.md)
endforeach()
list(REMOVE_ITEM AMONTONS_OTHER_PAGES ${AMONTONS_PAGES})
set(AMONTONS_PAGES ${CMAKE_SOURCE_DIR}/README.md ${AMONTONS_PAGES} ${AMONTONS_OTHER_PAGES} ${CMAKE_SOURCE_DIR}/CONTRIBUTING.md ${CMAKE_SOURCE_DIR}/CHANGELOG.md)
list(JOIN AMONTONS_PAGES " " AMONTONS_PAGES)
configure_file(doc/doxygen/Doxyfile.in ${CMAKE_BINARY_DIR}/doc/Doxyfile @ONLY)
configure_file(doc/doxygen/filtered.sh.in ${CMAKE_BINARY_DIR}/doc/filtered.sh @ONLY)
set(AMONTONS_HTML ${CMAKE_BINARY_DIR}/doc/html)
# Only what draws TeX as SVG.
set(AMONTONS_MATHJAX_PARTS extensions jax/element jax/input/TeX jax/output/SVG)
set(AMONTONS_COPY_MATHJAX COMMAND ${CMAKE_COMMAND} -E copy ${AMONTONS_MATHJAX}/MathJax.js ${AMONTONS_HTML}/mathjax/MathJax.js)
foreach(part ${AMONTONS_MATHJAX_PARTS})
  list(APPEND AMONTONS_COPY_MATHJAX COMMAND ${CMAKE_COMMAND} -E copy_directory ${AMONTONS_MATHJAX}/${part} ${AMONTONS_HTML}/mathjax/${part})
endforeach()
add_custom_target(doc
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${AMONTONS_HTML} ${CMAKE_BINARY_DIR}/doc/filtered
  COMMAND ${CMAKE_COMMAND} -E make_directory ${AMONTONS_HTML}/mathjax/jax/input ${AMONTONS_HTML}/mathjax/jax/output
  ${AMONTONS_COPY_MATHJAX}
  COMMAND python3 ${CMAKE_SOURCE_DIR}/doc/doxygen/filter.py ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/doc/filtered ${AMONTONS_HTML}
  COMMAND ${DOXYGEN_EXECUTABLE} ${CMAKE_BINARY_DIR}/doc/Doxyfile
  COMMAND ${CMAKE_COMMAND} -E echo "${AMONTONS_HTML}/index.html, without warnings"
  WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} VERBATIM)
