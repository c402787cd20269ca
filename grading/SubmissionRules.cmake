# Writes rules.toml: how a submission's files are compiled, and linked with a worker, while a teacher grades or a student
# renders. The builder in framework/submission reads it.
find_package(OpenMP COMPONENTS CXX) # course files parallelise with it

# A line name = ['word', 'word', ...]. The words of the list may come from generator expressions; empty ones do no harm.
function(add_rule name words)
    set(rules "${rules}${name} = ['$<JOIN:${words},'$<COMMA> '>']\n" PARENT_SCOPE)
endfunction()

set(includes $<TARGET_PROPERTY:raywork_interface,INTERFACE_INCLUDE_DIRECTORIES>)
set(definitions $<TARGET_PROPERTY:raywork_interface,INTERFACE_COMPILE_DEFINITIONS>)
set(flags "-std=c++20;-Wmissing-declarations;$<$<CONFIG:Release>:-O3>;$<$<CONFIG:Release>:-DNDEBUG>")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND flags -fmax-errors=20)
    set(only_objects -fno-lto -fno-use-linker-plugin) # nothing that an object holds is compiled once more
endif()

# A compiled header serves only those who compile with the same words; the others read the header that lies beside it.
set(compile "${CMAKE_CXX_COMPILER};${flags};-I$<JOIN:${includes},$<SEMICOLON>-I>;-D$<JOIN:${definitions},$<SEMICOLON>-D>;\
$<TARGET_PROPERTY:raywork_interface,INTERFACE_COMPILE_OPTIONS>;${OpenMP_CXX_FLAGS}")
set(prelude ${CMAKE_BINARY_DIR}/prelude/prelude.h)
configure_file(${CMAKE_SOURCE_DIR}/framework/submission/prelude.h ${prelude} COPYONLY)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_custom_command(OUTPUT ${prelude}.gch DEPENDS ${prelude} DEPFILE ${prelude}.d VERBATIM COMMAND_EXPAND_LISTS
        COMMAND ${compile} -MD -MF ${prelude}.d -MT ${prelude}.gch -x c++-header -o ${prelude}.gch ${prelude})
    add_custom_target(prelude DEPENDS ${prelude}.gch)
    add_dependencies(submission prelude)
endif()

set(rules "# Written by CMake.\n")
add_rule(compile "${compile};-I${CMAKE_BINARY_DIR}/prelude;-include;prelude.h")
find_program(GOLD ld.gold)
if(GOLD)
    set(linker -fuse-ld=gold) # links seven small workers in the time of two
endif()
add_rule(link "${CMAKE_CXX_COMPILER};${only_objects};${linker}")
add_rule(symbols "${CMAKE_READELF};--wide;--demangle;--symbols")

set(worker $<TARGET_OBJECTS:worker>)
set(probes $<TARGET_OBJECTS:probes>)
set(stress_probes $<TARGET_OBJECTS:stress_probes>)
set(libraries "$<TARGET_FILE:framework>;$<TARGET_FILE:TBB::tbb>;$<TARGET_FILE:fmt::fmt>;\
$<TARGET_FILE:tinyobjloader::tinyobjloader>;$<TARGET_PROPERTY:PkgConfig::stb,INTERFACE_LINK_LIBRARIES>;\
$<TARGET_PROPERTY:PkgConfig::tomlplusplus,INTERFACE_LINK_LIBRARIES>;\
$<TARGET_PROPERTY:PkgConfig::sodium,INTERFACE_LINK_LIBRARIES>;-pthread;${OpenMP_CXX_FLAGS}")
add_rule(built "${worker};${probes};${stress_probes};$<TARGET_OBJECTS:reference>;$<TARGET_FILE:framework>")
add_rule(rest_whole "${worker};${libraries}")
add_rule(rest_questioned "${worker};${probes};${libraries}")
add_rule(rest_stressed "${worker};${stress_probes};${libraries}")
if(RAYWORK_REPORT)
    add_rule(rest_figures "${worker};$<TARGET_OBJECTS:figure_probes>;${libraries}")
    add_dependencies(submission figure_probes)
endif()
foreach(feature IN LISTS FEATURES)
    set(others $<FILTER:$<TARGET_OBJECTS:reference>,EXCLUDE,/${feature}\\.cpp\\.o$>)
    add_rule(rest_${feature} "${worker};${probes};${others};${libraries}")
    add_rule(rest_stressed_${feature} "${worker};${stress_probes};${others};${libraries}")
endforeach()
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/rules.toml CONTENT "${rules}")
