# What our own code is compiled with; submissions and third-party headers are not held to it. Warnings are errors with the
# compiler that we test with: a newer one may know of more.
add_library(raywork_warnings INTERFACE)
target_compile_options(raywork_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-missing-field-initializers
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Werror>)
