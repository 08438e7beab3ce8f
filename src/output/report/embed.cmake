# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DOUTPUT=… -Dstyle=FILE -Dprogram=FILE -Dplotly=FILE -P embed.cmake
#
# Writes the files a report is made of as texts in C++. The same files give the same bytes.
cmake_minimum_required(VERSION 3.25)
set(source "// made by embed.cmake\n#include \"assets.hpp\"\n\nnamespace setae::report::assets {\n\n")
foreach(name style program plotly)
  file(READ ${${name}} text)
  file(SIZE ${${name}} size)
  string(FIND "${text}" ")SETAE_ASSET\"" end_mark)
  if(NOT end_mark EQUAL -1)
    message(FATAL_ERROR "${${name}} holds the sign that ends a text in C++")
  endif()
  string(APPEND source "static constexpr char ${name}_text[] = R\"SETAE_ASSET(${text})SETAE_ASSET\";\n"
                       "static_assert(sizeof(${name}_text) == ${size} + 1, \"${name} is whole\");\n"
                       "const std::string_view ${name}{${name}_text, ${size}};\n\n")
endforeach()
file(WRITE ${OUTPUT} "${source}}  // namespace setae::report::assets\n")
