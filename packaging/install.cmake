# What `cmake --install build --prefix P` writes: the program, its libraries and headers for find_package(Amontons), scenes with
# their meshes, and the documentation. Two parts, which become two packages: `program` and `library`.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(AMONTONS_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Amontons)

install(TARGETS amontons RUNTIME COMPONENT program)
install(DIRECTORY parameters DESTINATION ${CMAKE_INSTALL_DATADIR}/amontons COMPONENT program)
install(FILES README.md CHANGELOG.md CONTRIBUTING.md AUTHORS LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY doc DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
        FILES_MATCHING PATTERN *.md PATTERN *.csv PATTERN *.svg PATTERN *.png PATTERN example_library/* PATTERN doxygen EXCLUDE)

# Pages name scenes as ../parameters/SCENE.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/links)
file(RELATIVE_PATH AMONTONS_SCENES_FROM_PAGES ${CMAKE_INSTALL_FULL_DOCDIR} ${CMAKE_INSTALL_FULL_DATADIR}/amontons/parameters)
file(CREATE_LINK ${AMONTONS_SCENES_FROM_PAGES} ${CMAKE_BINARY_DIR}/links/parameters SYMBOLIC)
install(DIRECTORY ${CMAKE_BINARY_DIR}/links/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# Static: the program is one file, and there is no promise of a stable binary interface yet. Optimised, without assertions, as the
# program is.
set_target_properties(amontons_release PROPERTIES EXPORT_NAME amontons OUTPUT_NAME amontons)
set_target_properties(amontons_verification_release PROPERTIES EXPORT_NAME verification OUTPUT_NAME amontons_verification)
target_compile_features(amontons_release PUBLIC cxx_std_17)
install(TARGETS amontons_release amontons_verification_release EXPORT AmontonsTargets ARCHIVE COMPONENT library)
install(DIRECTORY include/amontons DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)

install(EXPORT AmontonsTargets NAMESPACE Amontons:: DESTINATION ${AMONTONS_CMAKE_DIR} COMPONENT library)
configure_package_config_file(packaging/AmontonsConfig.cmake.in ${CMAKE_BINARY_DIR}/AmontonsConfig.cmake
                              INSTALL_DESTINATION ${AMONTONS_CMAKE_DIR} PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/AmontonsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/AmontonsConfig.cmake ${CMAKE_BINARY_DIR}/AmontonsConfigVersion.cmake
        DESTINATION ${AMONTONS_CMAKE_DIR} COMPONENT library)
