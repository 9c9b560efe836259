# mien_embed(FILE NAME OUT): makes C++ sources that hold the bytes of FILE as `mien::NAME()`, a std::string.
function(mien_embed file name out)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}.cxx")
  set(header "${CMAKE_CURRENT_BINARY_DIR}/${name}.h")
  add_custom_command(OUTPUT "${source}" "${header}"
    COMMAND "${CMAKE_COMMAND}" "-DINPUT=${file}" "-DNAME=${name}" "-DSOURCE=${source}" "-DHEADER=${header}"
      -P "${Mien_SOURCE_DIR}/cmake/EmbedFile.cmake"
    DEPENDS "${file}" "${Mien_SOURCE_DIR}/cmake/EmbedFile.cmake"
    VERBATIM)
  set(${out} "${source}" PARENT_SCOPE)
endfunction()
