#pragma once

// A stub calls this with its name (a string literal) and goes on with something harmless. The first call for each name
// says so on the terminal; a grader asks afterwards which functions were met.
void notWrittenYet(const char* function);
