# The one home of the include law: a folder under src/ or tools/ is a target, and its DEPENDS are all that it may include.
# tests/law compares every #include with the DEPENDS of each call.

add_library(geminga_flags INTERFACE)
# The modules that another project links when it uses the client; tools/dev/install.cmake installs them.
set(geminga_client_modules base env identity discovery/gcnp client/protocol client/channels client/cpp)
target_compile_features(geminga_flags INTERFACE cxx_std_23)
target_compile_options(geminga_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
# A product and a sum are rounded one after the other on every machine, so that a simulated run has one trace.
target_compile_options(geminga_flags INTERFACE -ffp-contract=off)
# std::stable_sort of GCC 12's library uses what it deprecates itself, and clang says so at every instance. Of a std::array clang also
# wants the braces doubled, which C++ lets leave out.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  target_compile_options(geminga_flags INTERFACE -Wno-deprecated-declarations -Wno-missing-braces)
endif()
if(GEMINGA_SANITIZE)
  target_compile_options(geminga_flags INTERFACE -fsanitize=${GEMINGA_SANITIZE} -fno-omit-frame-pointer
                                                 -fno-sanitize-recover=all)
  target_link_options(geminga_flags INTERFACE -fsanitize=${GEMINGA_SANITIZE})
  # GCC says so itself, clang 19 does not.
  foreach(sanitizer address thread)
    if(GEMINGA_SANITIZE MATCHES ${sanitizer} AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
      string(TOUPPER __SANITIZE_${sanitizer}__ macro)
      target_compile_definitions(geminga_flags INTERFACE ${macro}=1)
    endif()
  endforeach()
  if(GEMINGA_SANITIZE MATCHES address)
    # AddressSanitizer stops at the access that follows from these, and they are a fifth of the time of a compilation.
    target_compile_options(geminga_flags INTERFACE -fno-sanitize=null,object-size,pointer-overflow)
  endif()
  if(GEMINGA_SANITIZE MATCHES thread)
    # Asio's fences are nothing that ThreadSanitizer of GCC 12 follows; each of our loops runs on one thread. With it GCC 12 also
    # sees strings written past their end that are not.
    target_compile_options(geminga_flags INTERFACE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread>)
  endif()
  # GCC 12 reports false positives of these two under the sanitizers (GCC bug 105562 and its kin).
  target_compile_options(geminga_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-restrict>)
endif()

if(GEMINGA_BUILD_FUZZERS)
  # Without it libFuzzer sees no edge of what it calls and only guesses.
  target_compile_options(geminga_flags INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(geminga_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# geminga_united(TARGET COUNT): COUNT files are compiled as one, since most of the time of each is reading the same headers. The preset
# dev and tools/dev/compile-alone compile each by itself, so that a missing #include is found there.
function(geminga_united target count)
  if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${count})
    # It asks whether a type of an unnamed namespace stands in a header, which is what a united file looks like to it.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# geminga_module(NAME SOURCES file... [DEPENDS module...] [LINK external-target...])
# Makes the static library geminga_NAME from src/NAME, or from NAME where that is tools/shell. `#include "other/..."` needs `other` in
# DEPENDS; the public face <geminga/...> is open to all.
function(geminga_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;DEPENDS;LINK")
  string(REPLACE "/" "_" target "geminga_${name}")
  add_library(${target} STATIC ${arg_SOURCES})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                              $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:geminga_flags>)
  geminga_harden_objects(${target} ${name})
  geminga_united(${target} 16)
  target_link_libraries(${target} PUBLIC ${arg_LINK})
  foreach(module IN LISTS arg_DEPENDS)
    string(REPLACE "/" "_" module ${module})
    target_link_libraries(${target} PUBLIC geminga_${module})
  endforeach()
endfunction()

# geminga_program(NAME [SECTION 8] [PACKAGE package] SOURCES file... [DEPENDS module...] [LINK external-target...]): an installed
# executable. Its DEPENDS are the law of its folder. Its page stands in that section of the manual, 1 unless told, and it is in that Debian
# package, geminga unless told.
function(geminga_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SECTION;PACKAGE" "SOURCES;DEPENDS;LINK")
  if(NOT arg_PACKAGE)
    set(arg_PACKAGE geminga)
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(${name} PRIVATE geminga_flags ${arg_LINK})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  geminga_harden_objects(${name} ${name})
  geminga_harden_link(${name})
  set_property(GLOBAL APPEND PROPERTY geminga_hardened ${name})
  foreach(module IN LISTS arg_DEPENDS)
    string(REPLACE "/" "_" module ${module})
    target_link_libraries(${name} PRIVATE geminga_${module})
  endforeach()
  target_compile_definitions(${name} PRIVATE GEMINGA_VERSION="${PROJECT_VERSION}")
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${arg_PACKAGE})
  if(NOT arg_SECTION)
    set(arg_SECTION 1)
  endif()
  geminga_manual(${name} ${arg_SECTION} ${arg_PACKAGE})
endfunction()

# geminga_manual(PROGRAM SECTION PACKAGE): asks the program for its man page and its completions, and installs them. Not where it is
# compiled for another machine that nothing here can stand in for.
function(geminga_manual name section package)
  if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    return()
  endif()
  set(folder ${PROJECT_BINARY_DIR}/manual)
  file(MAKE_DIRECTORY ${folder})
  set(man ${folder}/${name}.${section})
  set(bash ${folder}/${name}.bash)
  set(zsh ${folder}/_${name})
  set(fish ${folder}/${name}.fish)
  add_custom_command(OUTPUT ${man} ${man}.gz ${bash} ${zsh} ${fish}
    COMMAND ${name} --describe man > ${man}
    COMMAND gzip -9n < ${man} > ${man}.gz
    COMMAND ${name} --describe bash > ${bash}
    COMMAND ${name} --describe zsh > ${zsh}
    COMMAND ${name} --describe fish > ${fish}
    DEPENDS ${name} VERBATIM)
  add_custom_target(${name}-manual ALL DEPENDS ${man}.gz ${bash} ${zsh} ${fish})
  set_property(GLOBAL APPEND PROPERTY geminga_manuals ${name}-manual)
  install(FILES ${man}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section} COMPONENT ${package})
  install(FILES ${bash} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${name} COMPONENT ${package})
  install(FILES ${fish} DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT ${package})
  # zsh looks into the first folder below /usr/local, and into the second one below /usr, where packages put their files.
  install(FILES ${zsh} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT not-packaged)
  install(FILES ${zsh} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT ${package} EXCLUDE_FROM_ALL)
endfunction()

# geminga_command_line(TARGET file...): compiles the files of a program that include CLI11 as one, except in the preset dev: each of
# them alone makes the whole of CLI11's code again, six seconds that the program needs once.
function(geminga_command_line target)
  if(CMAKE_DISABLE_PRECOMPILE_HEADERS)
    return()
  endif()
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP command_line)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# ccache needs -fpch-preprocess, and sloppiness = pch_defines,time_macros. Half of the time of compiling a test is optimising code that
# runs once. With a sanitizer GCC needs -O1, with which it reports array bounds falsely where nothing is sanitized.
set(geminga_simulating_options $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
set(geminga_test_options ${geminga_simulating_options})
if(NOT GEMINGA_SANITIZE)
  list(PREPEND geminga_test_options $<$<CONFIG:RelWithDebInfo>:-O0> $<$<CONFIG:RelWithDebInfo>:-g0>)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  list(PREPEND geminga_test_options -O0)
endif()

# The time after which a test hangs; a busy machine is ten times as slow as an idle one, and a sanitizer five times as slow.
set(geminga_test_timeout 300)
if(GEMINGA_SANITIZE)
  set(geminga_test_timeout 900)
endif()

# geminga_test_body(TARGET [SIMULATES]): how every target below tests/ that knows GoogleTest is compiled. Half of the time of such a
# compilation is reading the headers of tests/precompiled.hpp. The preset dev reads every header in each file, so that a missing
# #include is found there.
function(geminga_test_body target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SIMULATES" "" "")
  set(kind test)
  if(arg_SIMULATES)
    set(kind simulating)
  endif()
  set(precompiled geminga_precompiled_${kind})
  if(NOT TARGET ${precompiled})
    add_library(${precompiled} OBJECT ${PROJECT_SOURCE_DIR}/tests/precompiled.cpp)
    target_link_libraries(${precompiled} PRIVATE geminga_flags GTest::gmock)
    target_compile_options(${precompiled} PRIVATE "${geminga_${kind}_options}")
    target_precompile_headers(${precompiled} PRIVATE ${PROJECT_SOURCE_DIR}/tests/precompiled.hpp)
  endif()
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include
                                               ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${target} PRIVATE geminga_flags GTest::gmock)
  target_compile_definitions(${target} PRIVATE GEMINGA_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                               GEMINGA_BINARY_DIR="${PROJECT_BINARY_DIR}")
  target_compile_options(${target} PRIVATE "${geminga_${kind}_options}")
  target_precompile_headers(${target} REUSE_FROM ${precompiled})
endfunction()

# geminga_test_library(NAME SOURCES file... [DEPENDS module...] [LINK external-target...])
# Code that the tests of several modules share, compiled once; a test names it in its DEPENDS.
function(geminga_test_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;DEPENDS;LINK")
  add_library(geminga_${name} STATIC ${arg_SOURCES})
  geminga_test_body(geminga_${name})
  target_link_libraries(geminga_${name} PUBLIC ${arg_LINK})
  foreach(module IN LISTS arg_DEPENDS)
    string(REPLACE "/" "_" module ${module})
    target_link_libraries(geminga_${name} PUBLIC geminga_${module})
  endforeach()
endfunction()

# geminga_test(NAME [SIMULATES] [APART] [ONE_AT_A_TIME] SOURCES file... [DEPENDS module...] [LINK external-target...])
# The tests of one module: tests/NAME mirrors src/NAME. Every TEST is known to ctest under its own name. SIMULATES: the tests
# themselves run for long, and are compiled as the product is. Six files are compiled as one, but in the preset dev; APART: each by
# itself, since they give different things one name. ONE_AT_A_TIME: ctest starts none of its tests while another one runs.
function(geminga_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SIMULATES;APART;ONE_AT_A_TIME" "" "SOURCES;DEPENDS;LINK")
  string(REPLACE "/" "_" target "geminga_${name}_tests")
  add_executable(${target} ${arg_SOURCES})
  set(simulates)
  if(arg_SIMULATES)
    set(simulates SIMULATES)
  endif()
  geminga_test_body(${target} ${simulates})
  if(NOT arg_APART)
    geminga_united(${target} 6)
  endif()
  target_link_libraries(${target} PRIVATE GTest::gtest_main ${arg_LINK})
  foreach(module IN LISTS arg_DEPENDS)
    string(REPLACE "/" "_" module ${module})
    target_link_libraries(${target} PRIVATE geminga_${module})
  endforeach()
  set(properties TIMEOUT ${geminga_test_timeout})
  if(arg_ONE_AT_A_TIME)
    list(APPEND properties RESOURCE_LOCK ${target})
  endif()
  gtest_discover_tests(${target} DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
endfunction()
