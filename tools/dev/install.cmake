# Installs the programs (geminga_program), the ontologies, the public face and the C++ client as the CMake package Geminga:
# find_package(Geminga) gives Geminga::client.
include(CMakePackageConfigHelpers)

if(NOT TARGET geminga_client_cpp)
  return()
endif()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/geminga DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
foreach(module IN LISTS geminga_client_modules)
  string(REPLACE "/" "_" module ${module})
  install(TARGETS geminga_${module} EXPORT GemingaTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set_target_properties(geminga_${module} PROPERTIES EXPORT_NAME ${module})
endforeach()
set_target_properties(geminga_client_cpp PROPERTIES EXPORT_NAME client)
target_compile_features(geminga_client_cpp PUBLIC cxx_std_23)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Geminga)
install(EXPORT GemingaTargets NAMESPACE Geminga:: DESTINATION ${package_folder})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/GemingaConfig.cmake.in ${PROJECT_BINARY_DIR}/GemingaConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/GemingaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/GemingaConfig.cmake ${PROJECT_BINARY_DIR}/GemingaConfigVersion.cmake
        DESTINATION ${package_folder})
