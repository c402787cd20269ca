# find_headers(<name> <header>): a library that is headers alone, to link with by that name.
function(find_headers name header)
    find_path(${name}_FOLDER ${header} REQUIRED)
    if(NOT TARGET ${name})
        add_library(${name} INTERFACE)
        target_include_directories(${name} SYSTEM INTERFACE ${${name}_FOLDER})
    endif()
endfunction()
