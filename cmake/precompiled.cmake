# SPDX-License-Identifier: GPL-3.0-or-later
# Headers that nearly every source reads, compiled once: for libraries, and with GoogleTest for tests. Every file still includes what it
# uses; the presets without them (dev, asan) show where one does not.
option(SETAE_PRECOMPILED "compile common headers once" ON)
if(NOT SETAE_PRECOMPILED)
  return()
endif()
set(common <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <numeric> <optional> <span> <string> <string_view>
    <utility> <vector> <Eigen/Core> <fmt/format.h>)

add_library(setae_precompiled OBJECT cmake/precompiled.cpp)
set_target_properties(setae_precompiled PROPERTIES POSITION_INDEPENDENT_CODE ON)
setae_compile_options(setae_precompiled)
target_link_libraries(setae_precompiled PRIVATE Eigen3::Eigen fmt::fmt)
target_precompile_headers(setae_precompiled PRIVATE ${common})

add_library(setae_precompiled_quick OBJECT cmake/precompiled.cpp)
set_target_properties(setae_precompiled_quick PROPERTIES POSITION_INDEPENDENT_CODE ON)
setae_compile_options(setae_precompiled_quick)
setae_compile_quickly(setae_precompiled_quick)
target_link_libraries(setae_precompiled_quick PRIVATE Eigen3::Eigen fmt::fmt)
target_precompile_headers(setae_precompiled_quick PRIVATE ${common})

# for modules and the program that print JSON
add_library(setae_precompiled_json OBJECT cmake/precompiled.cpp)
set_target_properties(setae_precompiled_json PROPERTIES POSITION_INDEPENDENT_CODE ON)
setae_compile_options(setae_precompiled_json)
setae_compile_quickly(setae_precompiled_json)
target_link_libraries(setae_precompiled_json PRIVATE Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json)
target_precompile_headers(setae_precompiled_json PRIVATE ${common} <nlohmann/json.hpp>)

if(SETAE_TESTS)
  add_library(setae_precompiled_tests OBJECT cmake/precompiled.cpp)
  setae_compile_options(setae_precompiled_tests)
  setae_compile_quickly(setae_precompiled_tests)
  target_link_libraries(setae_precompiled_tests PRIVATE Eigen3::Eigen fmt::fmt GTest::gtest)
  target_precompile_headers(setae_precompiled_tests PRIVATE ${common} <filesystem> <fstream> <gtest/gtest.h>)
endif()
