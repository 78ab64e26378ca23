# Flags of compiler and linker by which a mistake with memory ends a program instead of serving a stranger.
# tests/hardening reads it from the files that were linked. Not under a sanitizer, which finds more and does not go together with FORTIFY,
# and not in tests, which only run here.
include(CheckCXXCompilerFlag)
include(CheckPIESupported)
check_pie_supported(LANGUAGES C CXX)

option(GEMINGA_HARDEN "Stack protector, FORTIFY, full RELRO, CET, stack clash protection, PIE; OFF to measure what they cost" ON)
if(GEMINGA_SANITIZE OR GEMINGA_BUILD_FUZZERS)
  set(GEMINGA_HARDEN OFF)
endif()
if(NOT GEMINGA_HARDEN)
  function(geminga_harden_objects target module)
  endfunction()
  function(geminga_harden_link target)
  endfunction()
  return()
endif()

set(geminga_hardening -fstack-protector-strong)
set(geminga_hardening_links LINKER:-z,relro LINKER:-z,now LINKER:-z,noexecstack)
check_cxx_compiler_flag(-fstack-clash-protection GEMINGA_HAS_STACK_CLASH_PROTECTION)
if(GEMINGA_HAS_STACK_CLASH_PROTECTION)
  list(APPEND geminga_hardening -fstack-clash-protection)
endif()
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|i.86)$")
  list(APPEND geminga_hardening -fcf-protection=full)
  # The linker says that a program is made for shadow stacks only if every object says so, and crt1.o of Debian 12 does not. It has no
  # code that a shadow stack would hinder. Nothing is said of indirect branches, for which its _start would need a mark in its code.
  include(CheckLinkerFlag)
  check_linker_flag(CXX LINKER:-z,shstk GEMINGA_HAS_SHADOW_STACK)
  if(GEMINGA_HAS_SHADOW_STACK)
    list(APPEND geminga_hardening_links LINKER:-z,shstk)
  endif()
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  list(APPEND geminga_hardening -mbranch-protection=standard)
endif()

# FORTIFY needs an optimising compiler; level 3 came with GCC 12 and clang 12. A build type of the builder's own brings its own flags.
set(geminga_fortify 3)
if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 12)
  set(geminga_fortify 2)
endif()
set(GEMINGA_IS_FORTIFIED OFF)
if(CMAKE_BUILD_TYPE MATCHES "^(Release|RelWithDebInfo|MinSizeRel)$")
  set(GEMINGA_IS_FORTIFIED ON)
  list(APPEND geminga_hardening -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=${geminga_fortify})
endif()

# geminga_harden_objects(TARGET MODULE): the objects of a module or program. The standard library checks indices, too, but in the engines:
# their inner loops index vectors by numbers that they made themselves, and BENCHMARKS.md says what it would cost.
function(geminga_harden_objects target module)
  target_compile_options(${target} PRIVATE "${geminga_hardening}"
                                           $<$<NOT:$<BOOL:$<TARGET_PROPERTY:POSITION_INDEPENDENT_CODE>>>:-fPIE>)
  if(NOT module MATCHES "^reasoning/(el|dl|taxonomy|placement)")
    target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
  endif()
endfunction()

# geminga_harden_link(TARGET): what is linked, a program or a shared library.
function(geminga_harden_link target)
  target_link_options(${target} PRIVATE "${geminga_hardening_links}")
endfunction()
