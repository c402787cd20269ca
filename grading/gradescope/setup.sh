#!/usr/bin/env bash
# Makes the autograder's image: the launcher installs and builds all that grading needs.
set -euo pipefail
exec "$(dirname "$(realpath "${BASH_SOURCE[0]}")")/raywork" grade --help
