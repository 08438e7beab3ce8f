# SPDX-License-Identifier: GPL-3.0-or-later
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${EXAMPLES}/library -B ${WORK}/build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${WORK}/prefix
    -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)

# the mappings came along and go by their names, wherever the folder stands
file(RENAME ${WORK}/prefix ${WORK}/moved)
file(COPY ${EXAMPLES}/../tests/cli/data/loop_eoh.txt DESTINATION ${WORK})
run(${WORK}/moved/bin/setae jkr import ${WORK}/loop_eoh.txt --mapping eoh -o ${WORK}/sensor.csv)
file(RENAME ${WORK}/moved ${WORK}/prefix)

# the recipe plants E = 0.7 MPa, so E* = 0.933 MPa
run(${WORK}/prefix/bin/setae lab make ${EXAMPLES}/tutorial/recipe.toml -o ${WORK}/data)
run(${WORK}/prefix/bin/setae jkr import ${WORK}/data/loops/smoother_soft.csv -o ${WORK}/loop.csv)
execute_process(COMMAND ${WORK}/build/works_of_adhesion ${WORK}/data/smoother/afm_1.txt ${WORK}/loop.csv
                OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
message("${output}")
if(NOT output MATCHES "E\\* 9\\.[0-9]+e\\+05 Pa" OR NOT output MATCHES "W 0\\.0[0-9]+ J/m2 predicted")
  message(FATAL_ERROR "expected E* 0.90 to 1.00 MPa and a work of adhesion between 0 and 0.1 J/m2")
endif()
