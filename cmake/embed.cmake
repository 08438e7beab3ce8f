# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DOUTPUT=FILE -DHEADER=FILE -DNAMESPACE=NAME -DTEXTS=NAME=FILE|NAME=FILE|… -P embed.cmake
#
# Writes files as texts in C++, each a std::string_view that the header declares. The same files give the same bytes.
cmake_minimum_required(VERSION 3.25)
string(REPLACE "|" ";" texts "${TEXTS}")
set(source "// made by embed.cmake\n#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\n")
foreach(entry ${texts})
  string(REGEX MATCH "^([^=]+)=(.+)$" entry "${entry}")
  set(name "${CMAKE_MATCH_1}")
  set(path "${CMAKE_MATCH_2}")
  file(READ "${path}" text)
  file(SIZE "${path}" size)
  string(FIND "${text}" ")SETAE_ASSET\"" end_mark)
  if(NOT end_mark EQUAL -1)
    message(FATAL_ERROR "${path} holds the sign that ends a text in C++")
  endif()
  string(APPEND source "static constexpr char text_${name}[] = R\"SETAE_ASSET(${text})SETAE_ASSET\";\n"
                       "static_assert(sizeof(text_${name}) == ${size} + 1, \"${name} is whole\");\n"
                       "const std::string_view ${name}{text_${name}, ${size}};\n\n")
endforeach()
file(WRITE ${OUTPUT} "${source}}  // namespace ${NAMESPACE}\n")
