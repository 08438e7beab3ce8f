# SPDX-License-Identifier: GPL-3.0-or-later
# install + find_package(setae): a stranger's project links setae::<module>
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/setae)
install(EXPORT setae NAMESPACE setae:: FILE setaeTargets.cmake DESTINATION ${package_dir})
configure_file(cmake/setaeConfig.cmake.in setaeConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/setaeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/setaeConfig.cmake ${PROJECT_BINARY_DIR}/setaeConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/dependencies.cmake DESTINATION ${package_dir})

# a package of Debian: program, libraries and headers under /usr; what the libraries need is found by dpkg-shlibdeps
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME setae)
set(CPACK_PACKAGE_CONTACT "The setae developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# figures are drawn by gnuplot; labels of scale bars are read by Tesseract, where it is there
set(CPACK_DEBIAN_PACKAGE_DEPENDS "gnuplot-nox | gnuplot, fonts-liberation")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libtesseract5, tesseract-ocr-eng")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, libboost-dev, libfmt-dev, nlohmann-json3-dev")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
include(CPack)
