// What every file of a submission starts from. It is compiled once, since the libraries below take the compiler longer
// than the file itself; they are those that the interface's headers include. Of the interface itself there is only what
// all its headers have in common: a file may call its own helpers like a function that it did not ask for.
#include "common.h"
#include <filesystem>
#include <random>
#include <span>
#include <variant>
