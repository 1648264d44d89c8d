# What is installed, by component, each a Debian package of its own (cpack -G DEB):
#   command  craze           the command
#   library  libcraze0       libcraze.so.0: the interface of craze.h
#   devel    libcraze-dev    headers, libcraze.a (C++), libcraze.so (C), find_package(craze)
#   python   python3-craze   the Python package, with its own copy of the library
include(CMakePackageConfigHelpers)

if(CRAZE_APP)
  install(TARGETS craze_app RUNTIME COMPONENT command)
  set(page docs/craze.1)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page})
  execute_process(COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/${page}
    OUTPUT_FILE ${PROJECT_BINARY_DIR}/craze.1.gz COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${PROJECT_BINARY_DIR}/craze.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
    COMPONENT command)
endif()

# All that C++ programs link, in one archive that needs nothing but the C++ library and threads.
add_library(craze_archive STATIC $<TARGET_OBJECTS:craze_core> $<TARGET_OBJECTS:craze_recipe>
  $<TARGET_OBJECTS:craze_engine> $<TARGET_OBJECTS:craze_io> $<TARGET_OBJECTS:craze_own_executor>)
set_target_properties(craze_archive PROPERTIES OUTPUT_NAME craze EXPORT_NAME craze LINKER_LANGUAGE CXX)
target_compile_features(craze_archive PUBLIC cxx_std_20)
target_compile_definitions(craze_archive PUBLIC EIGEN_DONT_VECTORIZE)
target_link_libraries(craze_archive PUBLIC Eigen3::Eigen Threads::Threads)
file(GLOB public_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/craze/*.h)
target_sources(craze_archive PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include
  FILES ${public_headers})
install(TARGETS craze_archive EXPORT craze-targets ARCHIVE COMPONENT devel
  FILE_SET HEADERS COMPONENT devel)
if(CRAZE_BINDINGS)
  set_target_properties(craze_shared PROPERTIES EXPORT_NAME c)
  install(TARGETS craze_shared EXPORT craze-targets LIBRARY COMPONENT library
    NAMELINK_COMPONENT devel)
endif()
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/craze)
install(EXPORT craze-targets NAMESPACE craze:: DESTINATION ${config} COMPONENT devel)
configure_package_config_file(cmake/craze-config.cmake.in craze-config.cmake
  INSTALL_DESTINATION ${config})
write_basic_package_version_file(craze-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/craze-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/craze-config-version.cmake
  DESTINATION ${config} COMPONENT devel)

if(CRAZE_BINDINGS)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/python/craze DESTINATION lib/python3/dist-packages
    COMPONENT python PATTERN __pycache__ EXCLUDE)
endif()
