# Unity builds: files of one room are compiled together, so that large headers are read and templates made once for all of
# them (doc/decisions.md has the figures). Names in anonymous namespaces are therefore unique within a room.
option(MIEN_UNITY "Compile the files of a room together" ON)

# mien_unity(TARGET MOST): groups of at most MOST files, in the order in which they are listed, within each folder. Files
# with definitions or options of their own are compiled alone, as are those with SKIP_UNITY_BUILD_INCLUSION.
function(mien_unity target most)
  if(NOT MIEN_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cxx$")
  foreach(source IN LISTS sources)
    get_filename_component(folder "${source}" DIRECTORY)
    get_filename_component(room "${folder}" NAME)
    if(NOT DEFINED number_in_${room})
      set(number_in_${room} 0)
    endif()
    math(EXPR group "${number_in_${room}} / ${most}")
    math(EXPR number_in_${room} "${number_in_${room}} + 1")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${room}${group}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A fixture in an anonymous namespace is not in the main file any more; no other file sees it.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()
