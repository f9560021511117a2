add_library(stromar_options INTERFACE)
target_compile_options(stromar_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  # g++ 12 warns of its own std::string (GCC bug 105651), and of anonymous namespaces in files that are compiled together
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-subobject-linkage>
  $<$<BOOL:${STROMAR_WERROR}>:-Werror>
  -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/= # the same objects from every checkout
  -ffp-contract=off # contraction changes results from processor to processor
  $<$<CONFIG:Release>:$<IF:$<BOOL:$<TARGET_PROPERTY:STROMAR_IS_TEST>>,-O1,-O3>>) # a test is compiled for longer than it runs
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  target_compile_options(stromar_options INTERFACE -march=x86-64-v2)
endif()
if(STROMAR_SANITIZE)
  target_compile_options(stromar_options INTERFACE -fsanitize=${STROMAR_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(stromar_options INTERFACE -fsanitize=${STROMAR_SANITIZE})
endif()

# With CMAKE_UNITY_BUILD files of a folder are compiled together, sixteen at a time, which takes half the time: the names in their
# anonymous namespaces differ. The preset dev compiles each by itself: a file names all that it needs.
set(STROMAR_COMPILED_TOGETHER 16 CACHE STRING "How many files of a folder are compiled together")
function(stromar_compile_together target)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} DIRECTORY)
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    math(EXPR batch "0${count_${folder}} / ${STROMAR_COMPILED_TOGETHER}")
    math(EXPR count_${folder} "0${count_${folder}} + 1")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${folder}${batch})
  endforeach()
  set_property(TARGET ${target} PROPERTY UNITY_BUILD_MODE GROUP)
endfunction()

# stromar_layer(NAME SOURCES a.cpp … LINK libraries …): the library stromar_NAME of the folder src/NAME.
# What it links is what it may include.
function(stromar_layer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(stromar_${name} STATIC ${ARG_SOURCES})
  target_include_directories(stromar_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(stromar_${name} PUBLIC ${ARG_LINK} PRIVATE stromar_options)
  stromar_compile_together(stromar_${name})
endfunction()

# stromar_program(NAME LINK libraries …): what every program has besides: warnings, and memory in huge pages.
function(stromar_program name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} stromar_options)
  if(NOT STROMAR_SANITIZE)
    target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/huge-pages.cpp)
    target_link_libraries(${name} PRIVATE ${STROMAR_JEMALLOC})
  elseif(STROMAR_SANITIZE MATCHES address)
    target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/keep-loaded.cpp)
  endif()
endfunction()
