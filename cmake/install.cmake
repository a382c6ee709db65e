# cmake --install BUILD [--prefix P]: the command, the libraries, the Python module, the headers of the libraries with a CMake
# package, the docs, manual pages and completions. Everything finds everything else by its own place, so that the prefix
# may be moved. Components: command, python, freecad, development; packages.cmake makes packages of them.
include(GNUInstallDirs)
set(docs ${CMAKE_INSTALL_DATAROOTDIR}/doc/burin)

# from BINARY_FOLDER to the libraries, as the loader takes it
function(burin_rpath target folder)
  file(RELATIVE_PATH up /${folder} /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${up}")
endfunction()

# What is there of a list of targets (pieces.cmake).
function(burin_targets found)
  set(targets)
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      list(APPEND targets ${target})
    endif()
  endforeach()
  set(${found} ${targets} PARENT_SCOPE)
endfunction()

burin_targets(libraries burin burin_io burin_cad burin_cairo)
burin_targets(programs burin_cli burin_csg burin_probe)
set_target_properties(${libraries} PROPERTIES INSTALL_RPATH "$ORIGIN")
# Beside libburin: what models say to Burin, and the script that runs OpenSCAD of npm's package.
set(openscad_files ${PROJECT_SOURCE_DIR}/samples/openscad/burin.scad
  ${PROJECT_SOURCE_DIR}/converters/openscad/node/openscad.mjs)
if(BURIN_OPENSCAD)
  burin_rpath(burin_csg ${CMAKE_INSTALL_LIBDIR}/burin)
  install(TARGETS burin_csg RUNTIME DESTINATION ${CMAKE_INSTALL_LIBDIR}/burin COMPONENT command)
  install(FILES ${openscad_files} DESTINATION ${CMAKE_INSTALL_LIBDIR}/burin/openscad COMPONENT command)
endif()
if(BURIN_COMMAND)
  burin_rpath(burin_cli ${CMAKE_INSTALL_BINDIR})
  install(TARGETS burin_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT command)
endif()
install(TARGETS ${libraries}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_SKIP COMPONENT command)
if(BURIN_PLUGINS)
  install(TARGETS burin_probe RUNTIME DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT command)
endif()
install(TARGETS burin burin_io LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_ONLY COMPONENT development)

# burin_install_python(FOLDER COMPONENT [EXCLUDE_FROM_ALL]): the Python package into FOLDER.
function(burin_install_python folder component)
  set(source ${PROJECT_SOURCE_DIR}/converters/python/burin)
  if(NOT TARGET burin_python)  # commands that are written in Python, without the module
    install(DIRECTORY ${source}/batch ${source}/book DESTINATION ${folder}/burin COMPONENT ${component} ${ARGN}
      FILES_MATCHING PATTERN "*.py" PATTERN __pycache__ EXCLUDE)
    return()
  endif()
  install(TARGETS burin_python LIBRARY DESTINATION ${folder}/burin COMPONENT ${component} ${ARGN})
  install(DIRECTORY ${source} DESTINATION ${folder} COMPONENT ${component} ${ARGN}
    FILES_MATCHING PATTERN "*.py" PATTERN py.typed PATTERN __pycache__ EXCLUDE)
  install(FILES ${CMAKE_BINARY_DIR}/python/burin/__init__.pyi DESTINATION ${folder}/burin COMPONENT ${component} ${ARGN})
endfunction()

# burin_install_bundle(FOLDER COMPONENT): the Python package into FOLDER with all of the kernel beside it, so that it needs
# nothing else of ours. Never a part of `cmake --install` without the component.
function(burin_install_bundle folder component)
  install(TARGETS burin_python ${libraries}
    LIBRARY DESTINATION ${folder} NAMELINK_SKIP COMPONENT ${component} EXCLUDE_FROM_ALL)
  if(BURIN_PLUGINS)
    install(TARGETS burin_probe RUNTIME DESTINATION ${folder} COMPONENT ${component} EXCLUDE_FROM_ALL)
  endif()
  if(BURIN_OPENSCAD)
    install(TARGETS burin_csg RUNTIME DESTINATION ${folder}/burin COMPONENT ${component} EXCLUDE_FROM_ALL)
  endif()
  install(FILES ${openscad_files} DESTINATION ${folder}/burin/openscad COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/converters/python/burin/ DESTINATION ${folder}
    COMPONENT ${component} EXCLUDE_FROM_ALL FILES_MATCHING PATTERN "*.py" PATTERN py.typed PATTERN __pycache__ EXCLUDE)
endfunction()

if(TARGET burin_python)
  add_custom_target(burin_bundle DEPENDS burin_python ${libraries} ${programs})
  burin_install_bundle(burin bundle)
  install(FILES ${CMAKE_BINARY_DIR}/python/burin/__init__.pyi DESTINATION burin COMPONENT bundle EXCLUDE_FROM_ALL)
  if(BURIN_COMMAND)
    install(TARGETS burin_cli RUNTIME DESTINATION burin/bin COMPONENT bundle EXCLUDE_FROM_ALL)
    set_property(TARGET burin_cli APPEND PROPERTY INSTALL_RPATH "$ORIGIN/..")
  endif()
  # Of the same depth as the folder of a package of Debian, lib/python3/dist-packages.
  burin_rpath(burin_python ${BURIN_PYTHON_FOLDER}/burin)
  set_property(TARGET burin_python APPEND PROPERTY INSTALL_RPATH "$ORIGIN")
endif()
burin_install_python(${BURIN_PYTHON_FOLDER} python)

get_property(modules GLOBAL PROPERTY BURIN_MODULES)
get_property(header_folders GLOBAL PROPERTY BURIN_IO_HEADERS)
foreach(module IN LISTS modules)
  get_target_property(folders ${module} HEADER_DIRS)
  if(folders)  # else a module without a header of its own
    list(APPEND header_folders ${folders})
  endif()
endforeach()
foreach(folder IN LISTS header_folders)
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
endforeach()

include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/burin)
configure_package_config_file(cmake/burin-config.cmake.in ${CMAKE_BINARY_DIR}/cmake/burin-config.cmake
  INSTALL_DESTINATION ${package} PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/cmake/burin-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/cmake/burin-config.cmake ${CMAKE_BINARY_DIR}/cmake/burin-config-version.cmake
  DESTINATION ${package} COMPONENT development)

install(DIRECTORY kernel/docs/ DESTINATION ${docs} COMPONENT command PATTERN "*.py" EXCLUDE
  PATTERN mkdocs.yml EXCLUDE PATTERN theme EXCLUDE)
install(FILES README.md LICENSE CHANGELOG.md DESTINATION ${docs} COMPONENT command)

if(BURIN_OPENSCAD)
  # What OpenSCAD models say to Burin.
  install(FILES ${PROJECT_SOURCE_DIR}/samples/openscad/burin.scad DESTINATION ${CMAKE_INSTALL_DATADIR}/burin/openscad
    COMPONENT command)
endif()

if(NOT BURIN_COMMAND)
  add_custom_target(burin_installed DEPENDS ${libraries} ${programs})
  return()
endif()
# Manual pages and completions, which the command itself prints.
set(described ${CMAKE_BINARY_DIR}/described)
add_custom_command(OUTPUT ${described}/done
  COMMAND ${CMAKE_COMMAND} -DBURIN=$<TARGET_FILE:burin_cli> -DFOLDER=${described} -P ${PROJECT_SOURCE_DIR}/cmake/self_description.cmake
  DEPENDS burin_cli ${PROJECT_SOURCE_DIR}/cmake/self_description.cmake VERBATIM)
add_custom_target(burin_self_description ALL DEPENDS ${described}/done)
# All that cmake --install copies: what `./dev build` and `./dev package` build.
add_custom_target(burin_installed DEPENDS ${libraries} ${programs} burin_self_description)
if(TARGET burin_python)
  add_dependencies(burin_installed burin_python burin_python_stub)
endif()
install(DIRECTORY ${described}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT command)
install(DIRECTORY ${described}/share/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT command)
