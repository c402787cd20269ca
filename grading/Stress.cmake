# Who asks under stress.
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_headers(boost_multiprecision boost/multiprecision/cpp_int.hpp)

# Cases register themselves, as checks do.
file(GLOB stress CONFIGURE_DEPENDS stress/*.cpp stress/oracle/*.cpp)
list(REMOVE_ITEM stress ${CMAKE_CURRENT_SOURCE_DIR}/stress/stress_main.cpp)
add_library(stress OBJECT ${stress})
target_precompile_headers(stress REUSE_FROM framework)
set_target_properties(stress PROPERTIES UNITY_BUILD ON)
target_include_directories(stress PUBLIC ${CMAKE_SOURCE_DIR})
target_link_libraries(stress PUBLIC submission nlohmann_json::nlohmann_json PRIVATE boost_multiprecision raywork_warnings)

add_executable(raywork-stress stress/stress_main.cpp harmless.cpp report.cpp write_whole.cpp unfinished_file.cpp
    ${CMAKE_SOURCE_DIR}/framework/app/progress_bar.cpp)
set_target_properties(raywork-stress PROPERTIES UNITY_BUILD ON)
target_link_libraries(raywork-stress PRIVATE stress CLI11::CLI11 raywork_warnings raywork_compile_fast)
