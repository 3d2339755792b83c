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
