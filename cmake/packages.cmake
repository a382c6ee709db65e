# `cpack` in the build folder, or ./dev package: packages for Debian of the components of install.cmake.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME burin)
set(CPACK_PACKAGE_VENDOR "The Burin team")
set(CPACK_PACKAGE_CONTACT "The Burin team <burin@localhost>" CACHE STRING "Who answers for the packages: Name <address>")
# The address that freecad_wb/tools/addresses.py wrote; none is known before.
file(STRINGS ${PROJECT_SOURCE_DIR}/package.xml repository REGEX "<url type=\"repository\"")
string(REGEX REPLACE "^.*>([^<]*)<.*$" "\\1" CPACK_PACKAGE_HOMEPAGE_URL "${repository}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL command development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Libraries of ours are in another package than the module of Python, where dpkg-shlibdeps would look for them.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(version "${PROJECT_VERSION}")

set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME burin)
set(CPACK_COMPONENT_COMMAND_DESCRIPTION "line art of CAD parts, meshes and functions, hidden lines removed
 Burin turns STEP files, FreeCAD and OpenSCAD models, meshes, spline surfaces,
 implicit functions and volumes into vector line art: contours, creases, and
 strokes along the surface that carry the tone.")
set(CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS "openscad, python3-burin, burin-freecad")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME burin-dev)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "headers of Burin's libraries and of its plug-ins
 For programs on burin::burin, the kernel, and burin::io, files, and for
 plug-ins, found by find_package(burin).")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "burin (= ${version}), libglm-dev, libfmt-dev")

if(TARGET burin_python)
  # Python of Debian looks elsewhere below /usr than below /usr/local.
  burin_install_python(lib/python3/dist-packages python_debian EXCLUDE_FROM_ALL)
  list(APPEND CPACK_COMPONENTS_ALL python_debian)
  set(CPACK_DEBIAN_PYTHON_DEBIAN_PACKAGE_NAME python3-burin)
  set(CPACK_COMPONENT_PYTHON_DEBIAN_DESCRIPTION "Burin's line art as a module of Python
 Scenes from files, arrays and functions; drawings as files and arrays;
 catalogues of drawings, and pictures in documentation.")
  set(CPACK_DEBIAN_PYTHON_DEBIAN_PACKAGE_SECTION python)
  # The compiled module is for one minor version of Python.
  string(REGEX MATCH "^3\\.([0-9]+)$" python ${BURIN_PYTHON_VERSION})
  math(EXPR next_minor "${CMAKE_MATCH_1} + 1")
  string(JOIN ", " CPACK_DEBIAN_PYTHON_DEBIAN_PACKAGE_DEPENDS "burin (= ${version})" "python3 (>= ${python})"
    "python3 (<< 3.${next_minor})" python3-numpy)
  set(CPACK_DEBIAN_PYTHON_DEBIAN_PACKAGE_SUGGESTS "git, python3-distributed, python3-sphinx")

  burin_install_addon(share/freecad/Mod/Burin freecad_debian EXCLUDE_FROM_ALL)
  list(APPEND CPACK_COMPONENTS_ALL freecad_debian)
  set(CPACK_DEBIAN_FREECAD_DEBIAN_PACKAGE_NAME burin-freecad)
  set(CPACK_DEBIAN_FREECAD_DEBIAN_PACKAGE_ARCHITECTURE all)
  set(CPACK_COMPONENT_FREECAD_DEBIAN_DESCRIPTION "illustrations by Burin in FreeCAD
 A workbench that makes line art which follows the model, shows it in the 3-D
 view and on pages of TechDraw, and exports it.")
  set(CPACK_DEBIAN_FREECAD_DEBIAN_PACKAGE_DEPENDS "python3-burin (= ${version}), freecad (>= 0.20)")
endif()

# Each package says by what right it may be copied.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} key)
  set(out)
  if(component MATCHES "_debian$")
    set(out EXCLUDE_FROM_ALL)
  endif()
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_${key}_PACKAGE_NAME}
    RENAME copyright COMPONENT ${component} ${out})
endforeach()
include(CPack)
