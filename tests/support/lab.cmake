# Whole daemons in network namespaces, as tests and benchmarks start them: no test framework is in it.
include_guard(GLOBAL)
add_library(geminga_lab STATIC ${CMAKE_CURRENT_LIST_DIR}/lab.cpp ${CMAKE_CURRENT_LIST_DIR}/lab_team.cpp
                               ${CMAKE_CURRENT_LIST_DIR}/process.cpp ${CMAKE_CURRENT_LIST_DIR}/process_figures.cpp
                               ${CMAKE_CURRENT_LIST_DIR}/talk.cpp)
target_include_directories(geminga_lab PUBLIC ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include)
target_compile_definitions(geminga_lab PRIVATE GEMINGA_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                               GEMINGA_BINARY_DIR="${PROJECT_BINARY_DIR}")
target_link_libraries(geminga_lab PRIVATE geminga_flags)
# A site of a thousand in one program, for tests and benchmarks of bridges.
add_executable(crowd ${CMAKE_CURRENT_LIST_DIR}/crowd.cpp)
target_link_libraries(crowd PRIVATE geminga_flags geminga_discovery_relaying)
