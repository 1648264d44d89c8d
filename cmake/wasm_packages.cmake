# The header-only packages for Emscripten: the system's own, seen through a folder of links, since
# their folder holds the headers of the system's C library as well. Makes the targets that
# find_package() makes elsewhere.
set(wasm_headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${wasm_headers})

# wasm_package(TARGET HEADER): `HEADER`, like Eigen/Dense, in the system's include folders.
function(wasm_package target header)
  string(REGEX MATCH "^[^/]+" package ${header})
  find_path(WASM_${package}_INCLUDE_DIR ${header} PATHS /usr/local/include /usr/include
    PATH_SUFFIXES eigen3 NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  file(CREATE_LINK ${WASM_${package}_INCLUDE_DIR}/${package} ${wasm_headers}/${package} SYMBOLIC)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE ${wasm_headers})
endfunction()

wasm_package(Eigen3::Eigen Eigen/Dense)
wasm_package(fmt::fmt-header-only fmt/format.h)
target_compile_definitions(fmt::fmt-header-only INTERFACE FMT_HEADER_ONLY=1)
wasm_package(nlohmann_json::nlohmann_json nlohmann/json.hpp)
wasm_package(tomlplusplus::tomlplusplus toml++/toml.h)
