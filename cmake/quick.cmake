# What makes the build quick: precompiled headers, and units of several sources. A source still stands alone: clang-tidy and the
# sanitizers' builds compile each on its own.

# burin_all_targets(FOLDER FOUND): the targets of a folder and of those below it.
function(burin_all_targets folder found)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(below IN LISTS folders)
    burin_all_targets(${below} more)
    list(APPEND targets ${more})
  endforeach()
  set(${found} "${targets}" PARENT_SCOPE)
endfunction()
burin_all_targets(${PROJECT_SOURCE_DIR}/kernel targets)
burin_all_targets(${PROJECT_SOURCE_DIR}/converters more)
list(APPEND targets ${more})

# Most of the time goes into headers that sources share, so eight of them compile as one unit. Names in the anonymous namespaces
# of a module must differ, therefore; what stands inside a function may be called like something of another source, which
# -Wshadow would take for a mistake. CGAL's units take a gigabyte and more each.
if(BURIN_JOIN)
  burin_all_targets(${PROJECT_SOURCE_DIR}/tests tests)
  list(REMOVE_ITEM tests test_visibility)  # GCC 12 warns falsely of an uninitialised style in its unit
  foreach(target IN LISTS targets tests)
    get_target_property(type ${target} TYPE)
    get_target_property(pool ${target} JOB_POOL_COMPILE)
    if(type MATCHES "^(OBJECT|STATIC|SHARED|MODULE)_LIBRARY$|^EXECUTABLE$" AND NOT pool)
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
      target_compile_options(${target} PRIVATE -Wno-shadow)
    endif()
  endforeach()
endif()

if(NOT BURIN_PRECOMPILE)
  return()
endif()

# The headers that most sources include are compiled once: std and GLM, with fmt for targets that link it. GCC uses them
# only if macros and flags are the same, so libraries and programs have their own. A source still includes what it uses:
# clang-tidy and the sanitizers' builds compile without this. <filesystem> is left out: its std::quoted would hide
# functions of that name. Tests are left out: GCC 12 warns there falsely, depending on the length of the sources' path.

set(headers <algorithm> <array> <cmath> <cstddef> <cstdint> <functional> <limits> <map> <memory> <numbers>
  <optional> <set> <span> <string> <string_view> <tuple> <unordered_map> <utility> <vector> <glm/glm.hpp>)

# burin_precompiled(NAME [HEADERS HEADER...] [LIBRARIES LIBRARY...])
function(burin_precompiled name)
  cmake_parse_arguments(P "" "" "HEADERS;LIBRARIES" ${ARGN})
  add_library(burin_precompiled_${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled/empty.cpp)
  target_link_libraries(burin_precompiled_${name} PRIVATE glm::glm ${P_LIBRARIES})
  target_compile_definitions(burin_precompiled_${name} PRIVATE
    $<TARGET_PROPERTY:burin_base,INTERFACE_COMPILE_DEFINITIONS>)
  target_precompile_headers(burin_precompiled_${name} PRIVATE ${headers} ${P_HEADERS})
  if(NOT name STREQUAL "library" AND NOT name STREQUAL "library_fmt")
    set_target_properties(burin_precompiled_${name} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(burin_precompiled_${name} PRIVATE -fPIE)
  endif()
endfunction()
burin_precompiled(library)
burin_precompiled(library_fmt HEADERS <fmt/format.h> LIBRARIES fmt::fmt)
burin_precompiled(program_fmt HEADERS <fmt/format.h> LIBRARIES fmt::fmt)

# What a target takes; empty: nothing. CGAL asks for other flags of the compiler.
function(burin_precompiled_kind target kind)
  get_target_property(type ${target} TYPE)
  get_target_property(pool ${target} JOB_POOL_COMPILE)
  get_target_property(own ${target} PRECOMPILE_HEADERS)
  get_target_property(linked ${target} LINK_LIBRARIES)
  set(found "")
  if(pool OR own OR target MATCHES "^burin_precompiled" OR NOT linked)
  elseif(type MATCHES "^(OBJECT|STATIC|SHARED)_LIBRARY$")
    set(found library)
    if("fmt::fmt" IN_LIST linked)
      set(found library_fmt)
    endif()
  elseif(type STREQUAL EXECUTABLE AND "fmt::fmt" IN_LIST linked)
    set(found program_fmt)
  endif()
  set(${kind} "${found}" PARENT_SCOPE)
endfunction()

foreach(target IN LISTS targets)
  burin_precompiled_kind(${target} kind)
  if(kind)
    target_precompile_headers(${target} REUSE_FROM burin_precompiled_${kind})
    # GCC 12 warns of what std::string does inside itself, where its header is precompiled.
    target_compile_options(${target} PRIVATE -Wno-array-bounds)
  endif()
endforeach()
