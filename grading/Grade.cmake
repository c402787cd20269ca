# Who grades; includes who asks under stress.
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(pugixml REQUIRED)
find_headers(boost_math boost/math/distributions/students_t.hpp)

# The worker whose answers are trusted.
add_executable(reference-worker)
target_link_libraries(reference-worker PRIVATE worker probes reference framework)

# What answers and pictures are judged by, and where expected answers come from: of no submission, so that tests take it
# alone.
file(GLOB oracles CONFIGURE_DEPENDS oracle/*.cpp)
add_library(oracles OBJECT ${oracles}
    chi_square.cpp picture_judge.cpp tiles.cpp welch.cpp
    expected.cpp live_reference.cpp golden_file.cpp sealed_file.cpp unfinished_file.cpp)

# Checks register themselves, so they are objects. Those of a feature that fill more than a file are <feature>_*.cpp.
list(TRANSFORM FEATURES REPLACE "(.+)" "checks/\\1.cpp" OUTPUT_VARIABLE checks)
file(GLOB parts CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} checks/*_*.cpp drawn/*.cpp)
add_library(grading OBJECT
    grade.cpp check.cpp exam.cpp secret.cpp row_store.cpp kept_messages.cpp expect.cpp harmless.cpp observations.cpp
    picture.cpp outputs.cpp times.cpp write_whole.cpp
    report.cpp report_table.cpp report_json.cpp report_junit.cpp report_gradescope.cpp report_html.cpp
    ${CMAKE_CURRENT_BINARY_DIR}/page.cpp
    ${checks} ${parts})
target_sources(grading INTERFACE $<TARGET_OBJECTS:oracles>)

foreach(library oracles grading)
    set_target_properties(${library} PROPERTIES UNITY_BUILD ON)
    target_precompile_headers(${library} REUSE_FROM framework)
    target_include_directories(${library} PUBLIC ${CMAKE_SOURCE_DIR})
    target_link_libraries(${library}
        PUBLIC submission nlohmann_json::nlohmann_json PkgConfig::sodium
        PRIVATE pugixml::pugixml boost_math raywork_warnings)
endforeach()

# The page that the report fills in: its style and its script put into it, all in one literal.
file(READ html/page.html page)
foreach(part css js)
    file(READ html/page.${part} text)
    string(REPLACE "{{${part}}}" "${text}" page "${page}")
endforeach()
configure_file(html/page.cpp.in page.cpp @ONLY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS html/page.html html/page.css html/page.js)

# The grader graded.
file(GLOB validation CONFIGURE_DEPENDS validate/*.cpp)
add_library(validation STATIC ${validation})
target_precompile_headers(validation REUSE_FROM framework)
target_include_directories(validation PUBLIC ${CMAKE_SOURCE_DIR})
target_link_libraries(validation PUBLIC submission PRIVATE raywork_warnings)

add_executable(raywork-grade
    grade_main.cpp options.cpp growing_grade.cpp stress_rows.cpp supervisor.cpp watch.cpp)
set_target_properties(raywork-grade PROPERTIES UNITY_BUILD ON)
target_link_libraries(raywork-grade PRIVATE
    validation grading stress CLI11::CLI11 raywork_warnings raywork_compile_fast)
add_dependencies(raywork-grade reference-worker)
