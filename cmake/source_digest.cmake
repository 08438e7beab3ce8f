# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DSOURCE_DIR=… -DOUTPUT=… -DBUILD=… -P source_digest.cmake
#
# Writes one line of C++ that names the sources of the library, the compiler and its flags by a digest: results kept on disk are those
# of the build that computed them. Tests and benchmarks do not count.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE sources ${SOURCE_DIR}/*.cpp ${SOURCE_DIR}/*.hpp)
list(FILTER sources EXCLUDE REGEX "/(tests|benchmarks)/")
list(SORT sources)
set(digests "")
foreach(source ${sources})
  file(SHA256 ${source} digest)
  cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE name)
  string(APPEND digests "${name} ${digest}\n")
endforeach()
string(SHA256 digest "${digests}${BUILD}")
string(SUBSTRING ${digest} 0 8 digest)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "extern const char* const setae_source_digest = \"@digest@\";\n" @ONLY)
