#!/usr/bin/env bash
# shellcheck disable=SC2016 # what a stand-in does is expanded when it runs
# What the launcher does around a command: run_test.sh check_<name>. It runs in a checkout of nothing but itself, among
# stand-ins for the tools it calls, so that nothing is installed or built.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
checkout=$scratch/check\ out
log=$scratch/log
caller=$PWD

fail() {
    echo "$*" >&2
    exit 1
}

expect_equal() { [[ $1 == "$2" ]] || fail "expected: $2"$'\n'"found:    $1"; }

# stand_in <program>: its body is what stdin says.
stand_in() {
    { echo '#!/usr/bin/env bash'; cat; } >"$1"
    chmod +x "$1"
}

make_checkout() {
    mkdir -p "$checkout/build/release/grading" "$checkout/build/release/framework" "$scratch/bin"
    cp "$here/raywork" "$here/vcpkg.json" "$checkout"
    export RAYWORK_LOG=$log INSTALLED_BUT=${1:-nothing} PATH=$scratch/bin:$PATH
    stand_in "$scratch/bin/sudo" <<<'exec "$@"'
    stand_in "$scratch/bin/apt-get" <<<'echo "apt-get $*" >>"$RAYWORK_LOG"'
    stand_in "$scratch/bin/dpkg-query" <<END
sed -n '/^needs="/,/^"/p' "$here/raywork" | awk '{ print "installed", \$2 }' | grep -vF " \$INSTALLED_BUT"
echo "config-files \$INSTALLED_BUT"
END
    stand_in "$scratch/bin/cmake" <<'END'
echo "noise of the build"
[[ $1 == --preset ]] || exit 0
echo "cmake $*" >>"$RAYWORK_LOG"
touch build/release/build.ninja
grep -o 'RAYWORK_[A-Z]*=O[NF]*' <<<"$*" | sed 's/=/:BOOL=/' >>build/release/CMakeCache.txt
END
    stand_in "$scratch/bin/ctest" <<<'echo "ctest in $PWD: $*"'
    stand_in "$checkout/build/release/grading/raywork-grade" <<<'echo "grade in $PWD:"; printf "<%s>" "$@"; exit 7'
    stand_in "$checkout/build/release/framework/raywork-render" <<<'echo render'
}

raywork() { "$checkout/raywork" "$@" 2>/dev/null; }

check_arguments_directory_and_exit_code_are_the_commands() {
    local code=0 output
    make_checkout
    output=$(raywork grade "a b" "" --help '*') || code=$?
    expect_equal "$output" "grade in $caller:"$'\n'"<a b><><--help><*>"
    expect_equal "$code" 7
}

check_works_through_a_link() {
    make_checkout
    ln -s "$checkout/raywork" "$scratch/bin/ray"
    expect_equal "$(ray render 2>/dev/null)" render
}

check_tests_run_in_the_checkout() {
    make_checkout
    expect_equal "$(raywork test -R "a b")" "ctest in $checkout: --preset release -R a b"
}

check_only_missing_packages_are_installed() {
    make_checkout libcli11-dev
    raywork grade >/dev/null || true
    expect_equal "$(grep -o 'install .*' "$log")" "install -y --no-install-recommends libcli11-dev"
}

check_nothing_is_installed_for_other_commands() {
    make_checkout libopenimageio-dev
    raywork grade >/dev/null || true
    expect_equal "$(grep -c apt-get "$log")" 0
}

check_a_part_once_configured_stays() {
    local command configured=()
    make_checkout
    for command in grade render grade test render grade; do
        raywork "$command" >/dev/null || true
        configured+=("$(grep -c '^cmake' "$log")")
    done
    expect_equal "${configured[*]}" "1 2 2 3 3 3"
}

check_a_failing_build_is_exit_69() {
    local code=0
    make_checkout
    stand_in "$scratch/bin/cmake" <<<'[[ $1 == --preset ]]'
    raywork grade || code=$?
    expect_equal "$code" 69
}

check_without_apt_missing_programs_are_one_line_and_exit_69() {
    local code=0 tool errors
    make_checkout
    rm "$scratch"/bin/*
    for tool in awk bash dirname env grep mkdir realpath xargs; do ln -s "$(command -v "$tool")" "$scratch/bin"; done
    errors=$(PATH=$scratch/bin CXX=no-compiler "$checkout/raywork" render 2>&1) || code=$?
    expect_equal "$errors" "raywork: render needs no-compiler cmake ninja pkg-config: please install"
    expect_equal "$code" 69
}

"$1"
