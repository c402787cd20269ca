# Prints the libraries that vcpkg.json asks for, one a line; fails if the file is not JSON.
file(READ vcpkg.json manifest)
string(JSON count LENGTH ${manifest} dependencies)
math(EXPR last "${count} - 1")
foreach(i RANGE ${last})
    string(JSON port GET ${manifest} dependencies ${i})
    message(${port})
endforeach()
