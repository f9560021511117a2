add_library(stromar_options INTERFACE)
target_compile_options(stromar_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> # g++ 12 warns of its own std::string (GCC bug 105651)
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

# stromar_layer(NAME SOURCES a.cpp … LINK libraries …): the library stromar_NAME of the folder src/NAME.
# What it links is what it may include.
function(stromar_layer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(stromar_${name} STATIC ${ARG_SOURCES})
  target_include_directories(stromar_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(stromar_${name} PUBLIC ${ARG_LINK} PRIVATE stromar_options)
endfunction()

# Makes leaks of drivers nameable in a program that uses OpenGL.
function(stromar_keep_drivers_loaded program)
  if(STROMAR_SANITIZE MATCHES address)
    target_sources(${program} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/keep-loaded.cpp)
  endif()
endfunction()
