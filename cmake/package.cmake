# SPDX-License-Identifier: GPL-3.0-or-later
# install + find_package(setae): a stranger's project links setae::<module>
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/setae)
install(EXPORT setae NAMESPACE setae:: FILE setaeTargets.cmake DESTINATION ${package_dir})
configure_file(cmake/setaeConfig.cmake.in setaeConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/setaeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/setaeConfig.cmake ${PROJECT_BINARY_DIR}/setaeConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/dependencies.cmake DESTINATION ${package_dir})
