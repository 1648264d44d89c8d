# Installed package: find_package(craze) then craze::craze.
include(CMakePackageConfigHelpers)
install(TARGETS craze EXPORT craze-targets FILE_SET HEADERS)
install(EXPORT craze-targets NAMESPACE craze:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/craze)
configure_package_config_file(cmake/craze-config.cmake.in craze-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/craze)
write_basic_package_version_file(craze-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/craze-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/craze-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/craze)
