# cmake --install BUILD [--prefix P]: the command, the libraries, the Python module, the kernel's headers with a CMake
# package, the docs. Everything finds everything else by its own place, so that the prefix may be moved.
include(GNUInstallDirs)
set(docs ${CMAKE_INSTALL_DATAROOTDIR}/doc/burin)

# from BINARY_FOLDER to the libraries, as the loader takes it
function(burin_rpath target folder)
  file(RELATIVE_PATH up /${folder} /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${up}")
endfunction()

set(libraries burin burin_cad burin_cairo)
set_target_properties(${libraries} PROPERTIES INSTALL_RPATH "$ORIGIN")
burin_rpath(burin_cli ${CMAKE_INSTALL_BINDIR})
burin_rpath(burin_csg ${CMAKE_INSTALL_LIBDIR}/burin)
install(TARGETS burin_csg RUNTIME DESTINATION ${CMAKE_INSTALL_LIBDIR}/burin)
install(TARGETS burin_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ${libraries}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_SKIP)
install(TARGETS burin_probe RUNTIME DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS burin LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_ONLY)

if(TARGET burin_python)
  burin_rpath(burin_python ${BURIN_PYTHON_FOLDER}/burin)
  install(TARGETS burin_python LIBRARY DESTINATION ${BURIN_PYTHON_FOLDER}/burin)
  install(FILES ${CMAKE_BINARY_DIR}/python/burin/__init__.pyi
    DESTINATION ${BURIN_PYTHON_FOLDER}/burin)
endif()

get_property(modules GLOBAL PROPERTY BURIN_MODULES)
foreach(module IN LISTS modules)
  get_target_property(folders ${module} HEADER_DIRS)
  if(NOT folders)  # a module without a header of its own
    continue()
  endif()
  foreach(folder IN LISTS folders)
    install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  endforeach()
endforeach()

include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/burin)
configure_package_config_file(cmake/burin-config.cmake.in ${CMAKE_BINARY_DIR}/cmake/burin-config.cmake
  INSTALL_DESTINATION ${package} PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/cmake/burin-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/cmake/burin-config.cmake ${CMAKE_BINARY_DIR}/cmake/burin-config-version.cmake
  DESTINATION ${package})

install(DIRECTORY kernel/docs/ DESTINATION ${docs})
install(FILES README.md LICENSE CHANGELOG.md DESTINATION ${docs})

# What OpenSCAD models say to Burin.
install(FILES ${PROJECT_SOURCE_DIR}/samples/openscad/burin.scad DESTINATION ${CMAKE_INSTALL_DATADIR}/burin/openscad)
