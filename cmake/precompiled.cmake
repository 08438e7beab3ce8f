# SPDX-License-Identifier: GPL-3.0-or-later
# Headers that nearly every source reads, compiled once: for libraries, and with GoogleTest for tests. Every file still includes what it
# uses; the presets without them (dev, asan) show where one does not.
option(SETAE_PRECOMPILED "compile common headers once" ON)
if(NOT SETAE_PRECOMPILED)
  return()
endif()
set(common <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <numeric> <optional> <span> <string> <string_view>
    <utility> <vector> <Eigen/Core> <fmt/format.h>)

# setae_precompile(target [QUICK] [PIC] LINKS targets... HEADERS headers...): beside the common ones
function(setae_precompile target)
  cmake_parse_arguments(ARG "QUICK;PIC" "" "LINKS;HEADERS" ${ARGN})
  add_library(${target} OBJECT cmake/precompiled.cpp)
  if(ARG_PIC)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  setae_compile_options(${target})
  if(ARG_QUICK)
    setae_compile_quickly(${target})
  endif()
  target_link_libraries(${target} PRIVATE Eigen3::Eigen fmt::fmt ${ARG_LINKS})
  target_precompile_headers(${target} PRIVATE ${common} ${ARG_HEADERS})
endfunction()

setae_precompile(setae_precompiled PIC)
setae_precompile(setae_precompiled_quick QUICK PIC)
# for modules and the program that print JSON
setae_precompile(setae_precompiled_json QUICK PIC LINKS nlohmann_json::nlohmann_json HEADERS <nlohmann/json.hpp>)
if(SETAE_TESTS)
  setae_precompile(setae_precompiled_tests QUICK LINKS GTest::gtest HEADERS <filesystem> <fstream> <gtest/gtest.h>)
endif()
