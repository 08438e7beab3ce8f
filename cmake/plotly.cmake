# SPDX-License-Identifier: GPL-3.0-or-later
# setae_npm_file(variable PACKAGE name VERSION number SHA512 digest FILE path LOCAL file REMEDY text)
#
# One file of a package of npm, of exactly one version, known by the digest of its archive. `npm pack` fetches it once into the
# build tree, from the registry or the cache that npm is set up with on this machine; LOCAL takes its place where given. Nothing
# fetched enters the sources.
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
  set(package ${ARG_PACKAGE}@${ARG_VERSION})
  if(NOT EXISTS ${folder}/package/${ARG_FILE})
    find_program(SETAE_NPM npm DOC "npm, which fetches what pages of HTML need; not used where SETAE_PLOTLY is given")
    if(NOT SETAE_NPM)
      message(FATAL_ERROR "cannot fetch ${package}: npm is not found; install npm, or ${ARG_REMEDY}")
    endif()
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/_deps)
    execute_process(COMMAND ${SETAE_NPM} pack ${package} --pack-destination ${CMAKE_BINARY_DIR}/_deps --loglevel=error --ignore-scripts --prefer-offline
                            --fetch-retries=1 --fetch-retry-mintimeout=1000 --fetch-timeout=60000
                    WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/_deps OUTPUT_QUIET ERROR_VARIABLE reason RESULT_VARIABLE failure)
    if(failure)
      message(FATAL_ERROR "cannot fetch ${package} with ${SETAE_NPM} (${failure}); ${ARG_REMEDY}\n${reason}")
    endif()
    file(SHA512 ${archive} digest)
    if(NOT digest STREQUAL ARG_SHA512)
      file(REMOVE ${archive})
      message(FATAL_ERROR "${package}: SHA-512 ${digest}, expected ${ARG_SHA512}; ${ARG_REMEDY}")
    endif()
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${folder} PATTERNS package/${ARG_FILE} package/LICENSE)
  endif()
  set(${variable} ${folder}/package/${ARG_FILE} PARENT_SCOPE)
endfunction()

set(SETAE_PLOTLY "" CACHE FILEPATH "plotly-cartesian.min.js of plotly.js-cartesian-dist-min 4.1.1 for builds without network; empty: fetched by npm")

# draws the figures of reports (MIT licence); "cartesian" has lines, symbols and heat maps
setae_npm_file(SETAE_PLOTLY_FILE
               PACKAGE plotly.js-cartesian-dist-min VERSION 4.1.1 FILE plotly-cartesian.min.js LOCAL "${SETAE_PLOTLY}"
               SHA512 a3c1ab15ebac9dcc012316c1ca7449a58e29920541e9c68cf892e9c2b2d86dbb0eedd67c149f9254dd85afe2fb9221bf67ac383f93b426eb3f42be4479f1d57a
               REMEDY "configure with -DSETAE_PLOTLY=FILE, where FILE is package/plotly-cartesian.min.js of the archive that `npm pack` makes on a machine with network")
