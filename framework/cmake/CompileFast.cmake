# For code that is compiled more often than anybody waits for it: tests, command lines, reports. What computes for long is
# not among it.
add_library(raywork_compile_fast INTERFACE)
target_compile_options(raywork_compile_fast INTERFACE $<$<CONFIG:Release>:-O1>)
