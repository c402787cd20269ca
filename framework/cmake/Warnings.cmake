# What our own code is compiled with; submissions and third-party headers are not held to it.
add_library(raywork_warnings INTERFACE)
target_compile_options(raywork_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-missing-field-initializers -Werror)
