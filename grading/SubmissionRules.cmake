# Writes rules.ninja: how a submission's files are compiled, and linked with a worker, while a teacher grades or a student
# renders. The builder in framework/submission runs it.
find_package(OpenMP COMPONENTS CXX) # course files parallelise with it
set(includes $<TARGET_PROPERTY:raywork_interface,INTERFACE_INCLUDE_DIRECTORIES>)
set(definitions $<TARGET_PROPERTY:raywork_interface,INTERFACE_COMPILE_DEFINITIONS>)

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(error_limit -fmax-errors=20)
endif()

set(worker_objects "$<JOIN:$<TARGET_OBJECTS:worker>, >")
set(probe_objects "$<JOIN:$<TARGET_OBJECTS:probes>, >")
set(rests "rest_whole = $worker $libraries\nrest_questioned = $worker $probes $libraries\n")
foreach(feature IN LISTS FEATURES)
    set(others $<FILTER:$<TARGET_OBJECTS:reference>,EXCLUDE,/${feature}\\.cpp\\.o$>)
    string(APPEND rests "rest_${feature} = $worker $probes $<JOIN:${others}, > $libraries\n")
endforeach()

file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/rules.ninja CONTENT "\
# Written by CMake.
cxx = ${CMAKE_CXX_COMPILER_LAUNCHER} ${CMAKE_CXX_COMPILER}
flags = -std=c++20 -Wmissing-declarations ${error_limit} $<$<CONFIG:Release>:-O3 -DNDEBUG> \
-I$<JOIN:${includes}, -I> -D$<JOIN:${definitions}, -D> \
$<JOIN:$<TARGET_PROPERTY:raywork_interface,INTERFACE_COMPILE_OPTIONS>, > ${OpenMP_CXX_FLAGS}
worker = ${worker_objects}
probes = ${probe_objects}
libraries = $<TARGET_FILE:framework> $<TARGET_FILE:TBB::tbb> $<TARGET_FILE:fmt::fmt> \
$<TARGET_FILE:tinyobjloader::tinyobjloader> \
$<JOIN:$<TARGET_PROPERTY:PkgConfig::stb,INTERFACE_LINK_LIBRARIES>, > \
$<JOIN:$<TARGET_PROPERTY:PkgConfig::tomlplusplus,INTERFACE_LINK_LIBRARIES>, > -pthread ${OpenMP_CXX_FLAGS}
build archives: phony ${worker_objects} ${probe_objects} $<JOIN:$<TARGET_OBJECTS:reference>, > $<TARGET_FILE:framework>
${rests}
rule compile
  command = rm -f $out; LC_ALL=C timeout 60 $cxx $flags -MD -MF $out.d -c $in -o $out 2> $out.log
  depfile = $out.d
rule link
  command = rm -f $out; LC_ALL=C timeout 60 $cxx -o $out $in $rest 2> $out.log
")
