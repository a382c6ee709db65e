# cmake -DBUILD=FOLDER -DSTAGE=FOLDER -DARCHIVE=FILE -P archive.cmake: the add-on and its kernel as one zip.
file(REMOVE_RECURSE ${STAGE})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${STAGE} --component freecad_archive --strip
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
# Many programs that unpack zips know no links: each library stands there once, by the name that is asked for.
file(GLOB libraries ${STAGE}/Burin/freecad/burin_wb/native/burin/lib*)
foreach(library IN LISTS libraries)
  if(IS_SYMLINK ${library})
    file(REAL_PATH ${library} real)
    file(REMOVE ${library})
    file(RENAME ${real} ${library})
  endif()
endforeach()
file(REMOVE ${ARCHIVE})
execute_process(COMMAND ${CMAKE_COMMAND} -E tar cf ${ARCHIVE} --format=zip Burin WORKING_DIRECTORY ${STAGE}
  COMMAND_ERROR_IS_FATAL ANY)
