# SPDX-License-Identifier: GPL-3.0-or-later
# setae_npm_file(variable PACKAGE name VERSION number SHA512 digest FILE path LOCAL file REMEDY text)
#
# One file of a package of the npm registry, of exactly one version, fetched once into the build tree; LOCAL takes its place
# where given. Nothing fetched enters the sources.
function(setae_npm_file variable)
  cmake_parse_arguments(ARG "" "PACKAGE;VERSION;SHA512;FILE;LOCAL;REMEDY" "" ${ARGN})
  if(ARG_LOCAL)
    if(NOT EXISTS ${ARG_LOCAL})
      message(FATAL_ERROR "${ARG_LOCAL}: no such file; expected ${ARG_FILE} of ${ARG_PACKAGE} ${ARG_VERSION}")
    endif()
    set(${variable} ${ARG_LOCAL} PARENT_SCOPE)
    return()
  endif()
  set(folder ${CMAKE_BINARY_DIR}/_deps/${ARG_PACKAGE}-${ARG_VERSION})
  set(archive ${folder}.tgz)
  set(address https://registry.npmjs.org/${ARG_PACKAGE}/-/${ARG_PACKAGE}-${ARG_VERSION}.tgz)
  if(NOT EXISTS ${folder}/package/${ARG_FILE})
    file(DOWNLOAD ${address} ${archive} STATUS status INACTIVITY_TIMEOUT 60)
    list(GET status 0 failure)
    if(failure)
      list(GET status 1 reason)
      file(REMOVE ${archive})
      message(FATAL_ERROR "cannot fetch ${address} (${reason}); ${ARG_REMEDY}")
    endif()
    file(SHA512 ${archive} digest)
    if(NOT digest STREQUAL ARG_SHA512)
      file(REMOVE ${archive})
      message(FATAL_ERROR "${address}: SHA-512 ${digest}, expected ${ARG_SHA512}; ${ARG_REMEDY}")
    endif()
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${folder} PATTERNS package/${ARG_FILE} package/LICENSE)
  endif()
  set(${variable} ${folder}/package/${ARG_FILE} PARENT_SCOPE)
endfunction()

set(SETAE_PLOTLY "" CACHE FILEPATH "plotly-cartesian.min.js of plotly.js-cartesian-dist-min 4.1.1 for builds without network; empty: fetched from registry.npmjs.org")

# draws the figures of reports (MIT licence); "cartesian" has lines, symbols and heat maps
setae_npm_file(SETAE_PLOTLY_FILE
               PACKAGE plotly.js-cartesian-dist-min VERSION 4.1.1 FILE plotly-cartesian.min.js LOCAL "${SETAE_PLOTLY}"
               SHA512 a3c1ab15ebac9dcc012316c1ca7449a58e29920541e9c68cf892e9c2b2d86dbb0eedd67c149f9254dd85afe2fb9221bf67ac383f93b426eb3f42be4479f1d57a
               REMEDY "configure with -DSETAE_PLOTLY=FILE, where FILE is package/plotly-cartesian.min.js of that archive, got on a machine with network")
