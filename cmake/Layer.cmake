add_library(stromar_options INTERFACE)
target_compile_options(stromar_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  # g++ 12 warns of its own std::string (GCC bug 105651), of more where that is precompiled
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict $<$<NOT:$<BOOL:${CMAKE_DISABLE_PRECOMPILE_HEADERS}>>:-Wno-array-bounds -Wno-stringop-overflow>>
  $<$<BOOL:${STROMAR_WERROR}>:-Werror>
  -ffp-contract=off # contraction changes results from processor to processor
  $<$<CONFIG:Release>:$<IF:$<BOOL:$<TARGET_PROPERTY:STROMAR_IS_TEST>>,-O1,-O3>>) # a test is compiled for longer than it runs
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  target_compile_options(stromar_options INTERFACE -march=x86-64-v2)
endif()
if(STROMAR_SANITIZE)
  target_compile_options(stromar_options INTERFACE -fsanitize=${STROMAR_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(stromar_options INTERFACE -fsanitize=${STROMAR_SANITIZE})
endif()

# What nearly every file includes is read once, for all layers but the window's. The preset dev reads it anew for each: a file names all that
# it needs.
set(STROMAR_COMMON_HEADERS <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <glm/geometric.hpp> <glm/mat3x3.hpp> <glm/vec4.hpp>
                           <map> <memory> <optional> <span> <string> <thread> <vector>)
function(stromar_share_headers target)
  if(target STREQUAL "stromar_util")
    target_precompile_headers(stromar_util PRIVATE ${STROMAR_COMMON_HEADERS})
  else()
    target_precompile_headers(${target} REUSE_FROM stromar_util)
  endif()
endfunction()

# stromar_layer(NAME SOURCES a.cpp … LINK libraries …): the library stromar_NAME of the folder src/NAME.
# What it links is what it may include. HEADERS: its own to read once, instead of those that all share.
function(stromar_layer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;HEADERS" ${ARGN})
  add_library(stromar_${name} STATIC ${ARG_SOURCES})
  target_include_directories(stromar_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(stromar_${name} PUBLIC ${ARG_LINK} PRIVATE stromar_options)
  if(ARG_HEADERS)
    target_precompile_headers(stromar_${name} PRIVATE ${ARG_HEADERS})
  else()
    stromar_share_headers(stromar_${name})
  endif()
endfunction()

# Makes leaks of drivers nameable in a program that uses OpenGL.
function(stromar_keep_drivers_loaded program)
  if(STROMAR_SANITIZE MATCHES address)
    target_sources(${program} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/keep-loaded.cpp)
  endif()
endfunction()
