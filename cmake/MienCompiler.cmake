# Compiler settings for our own code, and the quick tools when they are there.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(BUILD_SHARED_LIBS ON CACHE BOOL "Build shared libraries")
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(MIEN_CCACHE ccache)
if(MIEN_CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER "${MIEN_CCACHE}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${MIEN_CCACHE}")
endif()
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=mold MIEN_HAVE_MOLD)
if(MIEN_HAVE_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

# Installed programs and libraries find each other wherever the installation is moved to.
set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")

option(MIEN_WARNINGS_AS_ERRORS "Treat warnings in our own code as errors" OFF)
set(MIEN_SANITIZE "" CACHE STRING "Sanitizers for the whole build, such as address,undefined or thread")
if(MIEN_SANITIZE)
  add_compile_options(-fsanitize=${MIEN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${MIEN_SANITIZE})
endif()

# Warnings for targets that hold our own code only.
function(mien_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra
    $<$<BOOL:${MIEN_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

include(MienUnity)
