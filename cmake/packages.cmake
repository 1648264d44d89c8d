# Debian packages: cpack -G DEB in the build folder.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME craze)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The craze authors <craze@users.noreply.github.com>")
set(CPACK_PACKAGE_HOMEPAGE_URL ${PROJECT_HOMEPAGE_URL})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
  GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL command library devel python)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
# It would come before the first line of each description.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")

# What Debian's tools know of a release; the changes themselves are in CHANGELOG.md.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # heeds SOURCE_DATE_EPOCH
file(WRITE ${PROJECT_BINARY_DIR}/packages/changelog
  "craze (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * Release ${PROJECT_VERSION}.\n\n"
  " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
execute_process(COMMAND gzip -9nf ${PROJECT_BINARY_DIR}/packages/changelog COMMAND_ERROR_IS_FATAL ANY)

# craze_package(COMPONENT NAME SECTION DEPENDS SUMMARY TEXT)
macro(craze_package component name section depends summary text)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}")
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${text}")
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${text}")
  configure_file(${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_BINARY_DIR}/packages/${name}/copyright COPYONLY)
  install(FILES ${PROJECT_BINARY_DIR}/packages/${name}/copyright
    ${PROJECT_BINARY_DIR}/packages/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
endmacro()

set(text "Grows cracks as in mud, glaze, glass or paint on triangle meshes: a stress per\n\
triangle is relaxed, and the surface cracks where it exceeds its strength.\n\
The method is that of Iben and O'Brien, Generating Surface Crack Patterns.")
craze_package(command craze graphics "" "surface crack patterns on triangle meshes" "${text}")
craze_package(library libcraze0 libs "" "surface crack patterns - shared library"
  "${text}\n.\nThis package has the library that programs link.")
craze_package(devel libcraze-dev libdevel "libcraze0 (= ${PROJECT_VERSION}), libeigen3-dev"
  "surface crack patterns - development files"
  "${text}\n.\nThis package has the headers for C and C++, and the library for C++.")
craze_package(python python3-craze python "python3, python3-numpy"
  "surface crack patterns - Python package"
  "${text}\n.\nThis package has the Python package craze: arrays in, arrays out.")
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# What packages of programs that link it depend on, and what makes it found.
file(WRITE ${PROJECT_BINARY_DIR}/packages/shlibs "libcraze 0 libcraze0 (>= ${PROJECT_VERSION})\n")
file(WRITE ${PROJECT_BINARY_DIR}/packages/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/packages/shlibs
  ${PROJECT_BINARY_DIR}/packages/triggers)
include(CPack)
