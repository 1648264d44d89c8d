# Installs the build in BUILD_DIR below WORK_DIR, then configures, builds and runs the consumer
# project against it. Run as cmake -DBUILD_DIR=… -DWORK_DIR=… -DCOMPILER=… -DFLAGS=… -P run.cmake
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK_DIR}/build
    -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/consumer ${WORK_DIR}/cracked.ply)
if(NOT EXISTS ${WORK_DIR}/cracked.ply)
  message(FATAL_ERROR "the consumer wrote no mesh")
endif()
