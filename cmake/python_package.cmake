# The Python package `burin`, as far as it is Python: commands that are written in it (`burin batch`, `burin book`) are there with or without the
# compiled module. For the system's Python alone: the one that FreeCAD has in it; another one that comes first on PATH is not asked.
set(BURIN_PYTHON_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The interpreter that the Python module is for")
set(Python3_EXECUTABLE ${BURIN_PYTHON_EXECUTABLE})
find_package(Python3 3.9 COMPONENTS Interpreter)
if(Python3_Interpreter_FOUND)
  set(BURIN_PYTHON_VERSION ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR})
else()
  set(BURIN_PYTHON_VERSION 3)
endif()
# Where Debian's Python looks below /usr/local; below another prefix PYTHONPATH says it.
set(BURIN_PYTHON_FOLDER lib/python${BURIN_PYTHON_VERSION}/dist-packages
  CACHE STRING "Folder below the prefix that the Python package is installed into")

block()
set(sources ${PROJECT_SOURCE_DIR}/converters/python/burin)
set(package ${CMAKE_BINARY_DIR}/python/burin)
file(GLOB_RECURSE files RELATIVE ${sources} CONFIGURE_DEPENDS ${sources}/batch/*.py ${sources}/book/*.py)
if(BURIN_PYTHON)
  list(APPEND files __init__.py __main__.py _draw.py _jupyter.py _plugins.py sphinx.py py.typed)
endif()
set(copies)
foreach(file IN LISTS files)
  add_custom_command(OUTPUT ${package}/${file}
    COMMAND ${CMAKE_COMMAND} -E copy ${sources}/${file} ${package}/${file}
    DEPENDS ${sources}/${file})
  list(APPEND copies ${package}/${file})
endforeach()
add_custom_target(burin_python_package ALL DEPENDS ${copies})
endblock()
