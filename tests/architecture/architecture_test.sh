#!/usr/bin/env bash
# What must be true of the repository's shape: architecture_test.sh check_<name> <feature>...
set -euo pipefail
shopt -s nullglob
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

failed=0
complain() {
    echo "$*" >&2
    failed=1
}

# Also what git does not know yet; without git, all that lies here but builds.
sources() {
    git ls-files --cached --others --exclude-standard --deduplicate -- '*.cpp' '*.h' 2>/dev/null ||
        find . -name build -prune -o \( -name '*.cpp' -o -name '*.h' \) -print | sed 's|^\./||'
}

# Lines "file:line:name", the name after its quote or bracket. Attacks include what they should not.
includes() {
    sources | grep -v '^tests/grading/attack/' | xargs grep -sHnoE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"][^>"]+' |
        sed -E 's/^([^:]*:[0-9]+):[^<"]*/\1:/'
}

# Where an include leads, empty for a header of the system. In to: a subshell for each include would take a minute.
find_target() {
    local from=$1 name=$2 folder
    for folder in "${from%/*}" framework . tests; do
        to=$folder/$name
        [[ -e $to || -e $to.in ]] || continue
        [[ $to != *./* ]] || to=$(realpath --relative-to=. -m "$to")
        return
    done
    to=
}

check_arrows() {
    local file line name to
    local -A may=([framework]="framework" [student]="framework" [reference]="framework" [grading]="framework grading"
        [report]="framework report" [tests]="framework grading report tests")
    while IFS=: read -r file line name; do
        find_target "$file" "${name:1}"
        if [[ -z $to ]]; then
            [[ $name == "<"* ]] || complain "$file:$line: found no ${name:1} in the folders that headers are looked up in"
        elif [[ $to == *.cpp ]]; then
            complain "$file:$line: includes $to, which is a source"
        elif [[ " ${may[${file%%/*}]-} " != *" ${to%%/*} "* ]]; then
            complain "$file:$line: includes $to, but ${file%%/*}/ may include ${may[${file%%/*}]-nothing} alone"
        fi
    done < <(includes)
}

# A feature's file may have parts: <feature>_<part>.cpp.
check_every_feature_has_its_files() {
    local feature file
    for feature; do
        for file in framework/"$feature".h {framework/unwritten,student,reference,grading/probes,grading/checks}/"$feature".cpp \
            report/figures/"$feature".cpp tests/features/"$feature"_test.cpp; do
            [[ -e $file ]] || complain "CMakeLists.txt:$(grep -n 'set(FEATURES' CMakeLists.txt | cut -d: -f1): no $file for the feature $feature"
        done
    done
    for file in {framework/unwritten,student,reference,grading/probes,grading/checks}/*.cpp; do
        feature=$(basename "$file" .cpp)
        feature=${feature%%_*}
        [[ " $* extra " == *" $feature "* ]] || complain "$file:1: found no feature $feature in CMakeLists.txt"
    done
}

check_sources_are_formatted() {
    command -v clang-format >/dev/null || exit 77 # skipped: nothing else needs it
    sources | xargs clang-format --dry-run --Werror || failed=1
}

check_files_and_lines_are_short() {
    local found
    found=$(sources | LC_ALL=C.UTF-8 xargs awk '
        FNR == 301 { print FILENAME ":301: found more than 300 lines" }
        length > 120 { print FILENAME ":" FNR ": found " length " columns, expected 120 at most" }')
    [[ -z $found ]] || complain "$found"
}

# CMake's lists break at these: names with them, and others beside them, would silently not be run.
check_names_of_tests_have_no_brackets_or_semicolons() {
    local found
    found=$(sources | xargs grep -sHnE 'TEST_CASE\("[^"]*[];[]' | sed -E 's/^([^:]*:[0-9]+):/\1: cannot be discovered: /') ||
        return 0
    complain "$found"
}

"$@"
exit $failed
