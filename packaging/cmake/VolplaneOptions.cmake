# Language level, warnings and sanitizers, once for all targets.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")

option(VOLPLANE_BUILD_TESTS "Build the test suite" ON)
option(VOLPLANE_BUILD_BENCHMARKS "Build the benchmark programs" OFF)
option(VOLPLANE_FUZZ "Build the fuzz targets of tests/fuzz and what they need of core, nothing else; takes clang" OFF)
option(VOLPLANE_FIND_IN_SOURCE "Programs look for resources in the source tree too, after the folder that they are installed in" ON)
option(VOLPLANE_PACKAGE "Make what a package holds beside the programs (manual pages, icons, changelog) in every build" OFF)
option(VOLPLANE_WARNINGS_AS_ERRORS "Treat warnings as errors" OFF)
# Debian's tools take the maintainer of a package from these two variables too; example.org belongs to nobody (RFC 2606).
set(maintainer "Volplane Maintainers <volplane@example.org>")
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
set(VOLPLANE_MAINTAINER "${maintainer}" CACHE STRING "Who made the package: NAME <ADDRESS>")
set(VOLPLANE_SANITIZE "" CACHE STRING "Sanitizers, for example address,undefined or thread")

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

# Two hundred test programs are linked in the presets that test, so a quick linker saves minutes there; packages are made by the compiler's own.
set(VOLPLANE_LINKER "" CACHE STRING "Linker to take if it is there, for example mold or lld; the compiler's own otherwise")
if(VOLPLANE_LINKER)
  find_program(VOLPLANE_LINKER_PROGRAM ld.${VOLPLANE_LINKER})
  if(VOLPLANE_LINKER_PROGRAM)
    add_link_options(-fuse-ld=${VOLPLANE_LINKER})
  endif()
endif()

add_library(vp_warnings INTERFACE)
target_compile_options(vp_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  -Wno-maybe-uninitialized  # false alarm of g++ 12 on std::stop_source
  # errors for the compilers that the code is kept free of warnings with; a newer one may know warnings that nobody has seen
  $<$<AND:$<BOOL:${VOLPLANE_WARNINGS_AS_ERRORS}>,$<OR:$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>,$<CXX_COMPILER_ID:Clang>>>:-Werror>)

if(VOLPLANE_FUZZ AND NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "Fuzz targets are built by clang alone: CXX=clang++-14 cmake --preset fuzz, or packaging/fuzz, which does that.")
endif()
if(VOLPLANE_SANITIZE)
  add_compile_options(-fsanitize=${VOLPLANE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${VOLPLANE_SANITIZE})
endif()
