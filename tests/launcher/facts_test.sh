#!/usr/bin/env bash
# What must be true of the launcher before it runs anything: facts_test.sh check_<name>.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

fail() {
    echo "$*" >&2
    exit 1
}

expect_equal() { [[ $1 == "$2" ]] || fail "expected: $2"$'\n'"found:    $1"; }

# The launcher's table, a row a line: name, package in Debian, commands.
table() { sed -n '/^needs="/,/^"/p' raywork | grep -v '"'; }

check_help_lists_every_command() {
    local text command
    text=$(./raywork help)
    for command in help $(table | awk '{ for (i = 3; i <= NF; i++) print $i }' | sort -u); do
        grep -q "^  $command  " <<<"$text" || fail "help does not list $command"
    done
}

check_help_answers_however_it_is_asked() {
    local question
    for question in "" -h --help "test --help" "test -h"; do
        # shellcheck disable=SC2086 # no argument, one or two
        expect_equal "$(./raywork $question)" "$(./raywork help)"
    done
}

check_help_needs_no_environment() { expect_equal "$(env -i PATH=/usr/bin:/bin ./raywork help)" "$(./raywork help)"; }

# So it answers at once, on a machine with nothing installed.
check_help_starts_no_program() { expect_equal "$(env -i PATH=/nowhere "$BASH" ./raywork help)" "$(./raywork help)"; }

check_unknown_command_is_one_line_and_exit_2() {
    local code=0 errors
    errors=$(./raywork grdae 2>&1 >/dev/null) || code=$?
    expect_equal "$code" 2
    expect_equal "$(wc -l <<<"$errors")" 1
    expect_equal "$(./raywork grdae 2>/dev/null)" ""
}

check_vcpkg_names_every_library() {
    local programs='[$]{CXX:-g++}|cmake|ninja|pkg-config|clang-format|chromium|gnuplot|pandoc|pdftotext|git|bwrap|math-font|Xvfb|xdotool|imgui|libseccomp' # or Linux's own
    expect_equal "$(cmake -P tests/launcher/ports.cmake 2>&1 | sort)" \
        "$(table | awk '{ print $1 }' | grep -vxE "${programs//+/[+]}" | sort)"
}

check_grade_and_render_need_no_window() {
    local window='glfw|glut|sdl|imgui|x11|wayland|mesa|opengl|libe?gl1?-|vulkan|gtk|qt'
    ! table | grep -E 'grade|render' | grep -iE "$window" || fail "a window library for who opens none"
}

check_ci_is_the_launchers_test() {
    [[ -x .ci/run ]] || fail ".ci/run cannot be executed"
    # shellcheck disable=SC2016 # literally
    expect_equal "$(cat .ci/run)" '#!/usr/bin/env bash
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec ./raywork test'
}

"$1"
