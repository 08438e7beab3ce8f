# SPDX-License-Identifier: GPL-3.0-or-later
# setae_module(name [QUICK] LINKS targets... PRIVATE targets... TEST_LINKS targets...)
#
# A module is one folder and one library setae::<name>. Its sources are the *.cpp beside CMakeLists.txt and in its rooms, the folders below it.
# QUICK: it calls what computes and computes nothing itself. include/ holds what users of the library may name, internal/ what other modules
# may, headers beside sources are the module's own: they are named from the module's folder ("fit/probe.hpp") or beside the source.
# Tests are tests/**/*_test.cpp, in one program a module (label "unit"); files named *_property_test.cpp go into one program of all modules
# (label "property"). Benchmarks are benchmarks/*_bench.cpp.
set(SETAE_INSTALLED ON)

function(setae_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  # designated initialisers leave fields at their defaults; the bounds that GCC 12 sees broken in std::string are false alarms (its
  # bugs 105329, 105651 and 105762), and the sanitizers look for true ones
  target_compile_options(${target} PRIVATE -Wno-missing-field-initializers
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict$<SEMICOLON>-Wno-array-bounds$<SEMICOLON>-Wno-stringop-overflow>)
  # without it GCC contracts a*b+c where the target has FMA, and bytes differ between builds
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(SETAE_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# What runs once and computes nothing itself: reading headers is most of its time in the compiler. At -O1 GCC takes members of a union
# for uninitialised.
function(setae_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1> $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
endfunction()

# Several sources compiled as one read their headers once: a third of the time from nothing, some seconds more after one edit. Names in
# unnamed namespaces are therefore each module's own, not each file's; the presets without it (dev, asan) show where a file lacks a header.
option(SETAE_TOGETHER "compile eight sources of a module as one" OFF)
function(setae_compile_together target)
  if(SETAE_TOGETHER)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()

# The sources of a module: beside its CMakeLists.txt and in its rooms, folders at any depth without one of their own.
function(setae_sources result)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/(tests|benchmarks|mpi)/")
  set(${result} ${sources} PARENT_SCOPE)
endfunction()

function(setae_module name)
  cmake_parse_arguments(ARG "QUICK" "" "LINKS;PRIVATE;TEST_LINKS" ${ARGN})
  set(here ${CMAKE_CURRENT_SOURCE_DIR})
  setae_sources(sources)
  add_library(setae_${name} ${sources})
  add_library(setae::${name} ALIAS setae_${name})
  set_target_properties(setae_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(setae_${name} PUBLIC $<BUILD_INTERFACE:${here}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  if(IS_DIRECTORY ${here}/internal)
    target_include_directories(setae_${name} PUBLIC $<BUILD_INTERFACE:${here}/internal>)
  endif()
  target_include_directories(setae_${name} PRIVATE ${here})
  target_link_libraries(setae_${name} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE})
  setae_compile_options(setae_${name})
  setae_compile_together(setae_${name})
  set(precompiled setae_precompiled)
  if(ARG_QUICK)
    setae_compile_quickly(setae_${name})
    set(precompiled setae_precompiled_quick)
    if("nlohmann_json::nlohmann_json" IN_LIST ARG_LINKS OR "nlohmann_json::nlohmann_json" IN_LIST ARG_PRIVATE)
      set(precompiled setae_precompiled_json)
    endif()
  endif()
  if(TARGET ${precompiled} AND "fmt::fmt" IN_LIST ARG_PRIVATE)
    target_precompile_headers(setae_${name} REUSE_FROM ${precompiled})
  endif()
  if(SETAE_INSTALLED)
    install(TARGETS setae_${name} EXPORT setae ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    if(IS_DIRECTORY ${here}/include)
      install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    endif()
  endif()

  set(known ${ARG_PRIVATE}) # tests and benchmarks may name what the module may
  list(FILTER known INCLUDE REGEX "^setae::")
  list(PREPEND known setae::${name})
  if(SETAE_TESTS)
    file(GLOB_RECURSE tests CONFIGURE_DEPENDS ${here}/tests/*_test.cpp)
    set(property_tests ${tests})
    list(FILTER property_tests INCLUDE REGEX "_property_test\\.cpp$")
    list(FILTER tests EXCLUDE REGEX "_property_test\\.cpp$")
    set(links ${known} ${ARG_TEST_LINKS})
    setae_tests(${name}_tests unit SOURCES ${tests} LINKS ${links} INCLUDES ${here} ${here}/tests)
    setae_tests(property_tests property SOURCES ${property_tests} LINKS ${links} rapidcheck INCLUDES ${here} ${here}/tests)
  endif()
  if(SETAE_BENCHMARKS)
    file(GLOB benchmarks CONFIGURE_DEPENDS benchmarks/*_bench.cpp)
    if(benchmarks)
      add_executable(${name}_bench ${benchmarks})
      setae_compile_options(${name}_bench)
      target_include_directories(${name}_bench PRIVATE ${here} ${here}/tests ${PROJECT_SOURCE_DIR}/tests/support)
      target_link_libraries(${name}_bench PRIVATE ${known} ${ARG_TEST_LINKS} PkgConfig::FFTW benchmark::benchmark_main)
    endif()
  endif()
endfunction()

# setae_embed(target header namespace NAME=FILE...): files as texts in C++, which the target's header declares.
function(setae_embed target header namespace)
  cmake_path(GET header STEM name)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}_texts.cpp)
  list(JOIN ARGN "|" texts)
  list(TRANSFORM ARGN REPLACE "^[^=]+=" "" OUTPUT_VARIABLE files)
  set(script ${PROJECT_SOURCE_DIR}/cmake/embed.cmake)
  add_custom_command(OUTPUT ${output}
                     COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DHEADER=${header} -DNAMESPACE=${namespace} -DTEXTS=${texts} -P ${script}
                     DEPENDS ${script} ${files} VERBATIM)
  target_sources(${target} PRIVATE ${output})
  # its names are each text's own
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

if(SETAE_TESTS)
  include(tests)
endif()
if(SETAE_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
