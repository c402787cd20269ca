#!/usr/bin/env bash
# shellcheck disable=SC2016,SC2046 # awk and dpkg expand what is quoted; packages are words
# A command lists what it needs, and no more: needs_test.sh <command> <build directory>. The command is configured anew as
# the launcher does it; of what its target is made, the given build says; what that came with, Debian says. Programs and
# fonts are in use if the sources name them between quotes.
set -euo pipefail
command=$1 build=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT

failed=0
complain() {
    echo "raywork: $*" >&2
    failed=1
}

skip() {
    echo "skipped: $*"
    exit 77
}

main() {
    command -v dpkg-query apt-cache >/dev/null || skip "only Debian's packages are known here, and this is no Debian"
    ! grep -q '^CMAKE_CXX_COMPILER:.*clang' "$build/CMakeCache.txt" || skip "what is listed is g++, and this build is Clang's"
    sed -n '/^needs="/,/^"/p' "$here/raywork" | awk -v command="$command" '
        { for (i = 3; i <= NF; i++) if ($i == command) print $2 }' | sort -u >"$scratch/listed"
    installed <"$scratch/listed" | comm -13 - "$scratch/listed" >"$scratch/absent"
    [[ ! -s $scratch/absent ]] || skip "$command lists what is not installed: $(xargs <"$scratch/absent")"

    plan
    find_what_it_is_made_of
    find_what_it_names
    cd "$scratch"
    find_owners
    check_all_is_listed
    check_all_listed_is_needed
    exit $failed
}

# Of a package that a machine never had, dpkg-query says that by its exit code too.
installed() {
    { xargs dpkg-query -W -f '${db:Status-Status} ${Package}\n' 2>/dev/null || true; } | sed -n 's/^installed //p' | sort -u
}

# The launcher, alone in a folder, among stand-ins: what it would configure is configured beside the build of this
# checkout, and what it would build is a list of commands.
plan() {
    mkdir -p "$scratch/alone" "$scratch/bin"
    cp "$here/raywork" "$here/vcpkg.json" "$scratch/alone"
    cat >"$scratch/bin/cmake" <<END
#!/usr/bin/env bash
if [[ \$1 == --build ]]; then exec ninja -C "$scratch/build" -t commands "\${@: -1}" >"$scratch/commands"; fi
cd "$here" && exec "$(command -v cmake)" "\$@" -B "$scratch/build"
END
    chmod +x "$scratch/bin/cmake"
    PATH=$scratch/bin:$PATH "$scratch/alone/raywork" "$command" >"$scratch/log" 2>&1 || true # there is no program to run
    [[ -s $scratch/commands ]] || { cat "$scratch/log" >&2; exit 1; }
}

# files: all that the target, its objects and its configuration read, of this checkout and of the system.
find_what_it_is_made_of() {
    grep -oE ' -o [^ /][^ ]*\.(o|gch)( |$)' "$scratch/commands" | awk '{ print $2 }' | sort -u >"$scratch/objects"
    xargs ninja -C "$build" -t deps <"$scratch/objects" >"$scratch/deps" 2>&1 ||
        skip "$command was never configured: $(grep -m 1 '^ninja: ' "$scratch/deps")"
    ! grep -q 'deps not found' "$scratch/deps" || skip "$command is not built: $(grep -m 1 'not found' "$scratch/deps")"
    {
        sed -n 's/^    //p' "$scratch/deps"
        grep -ohE '/[^ '\'']*\.(so[.0-9]*|a)\b' "$scratch/commands" "$scratch/build/rules.toml"
        ninja -C "$scratch/build" -t inputs build.ninja | grep ^/
        programs_of_cmake
        [[ $command != test ]] || find "$here/tests" -name launcher -prune -o -name '*.sh' -print
    } | sort -u | xargs realpath -ms | sort -u | grep -v "^$scratch" >"$scratch/files"
}

# ccache is used where it is.
programs_of_cmake() { sed -nE '/^CCACHE/d; s/^[A-Z_]+:(FILEPATH|INTERNAL)=(\/usr\/bin\/.*)/\2/p' "$scratch/build/CMakeCache.txt"; }

# words: what this checkout's files have between quotes, whole without its blanks, and its first word; and what scripts say.
# called: what they give to functions that run programs.
find_what_it_names() {
    grep "^$here/" "$scratch/files" | grep -v "^$build/" >"$scratch/sources"
    {
        xargs grep -ohE '"[^"]+"' <"$scratch/sources" | tr -d '"' | awk '{ print $1; gsub(/ /, ""); print }'
        sed -n '/\.sh$/p' "$scratch/sources" | xargs -r sed 's/^ *#.*//' | tr -s ' ' '\n'
    } | sort -u >"$scratch/words"
    { xargs grep -ohE '(exec|spawn|system|popen|[Rr]un)[A-Za-z]*\(+[^"]*"[^" ]+' <"$scratch/sources" || true; } |
        sed 's/.*"//' | sort -u >"$scratch/called"
    xargs grep -ohE '^#include <[^>]+>' <"$scratch/sources" | sed 's/.*<\(.*\)>/\1/' | sort -u >"$scratch/includes"
}

# A line "package file" in owned for each file that came with a package.
find_owners() {
    { cat files; called_programs; named_files; } | forms | { xargs dpkg-query -S 2>/dev/null || true; } |
        sed -nE 's/^([a-z0-9.+-]+)(:[a-z0-9]+)?: /\1 /p' | sort -u >owned
}

check_all_is_listed() {
    { dpkg-query -W -f '${Essential} ${Package}\n' | sed -n 's/^yes //p'; brought_by $(cat listed); } | sort -u >covered
    while read -r package file; do
        complain "$command uses $file of $package, which is not listed"
    done < <({ cat files; called_programs; } | owned_of |
        awk 'NR == FNR { covered[$1]; next } !($1 in covered) && !told[$1]++' covered -)
}

# A package is needed if something of it is in use, or of what comes with it and with no other that is listed.
check_all_listed_is_needed() {
    local package
    { included; programs_of_cmake; named_files; } | owned_of | cut -d ' ' -f 1 | sort -u >used
    for package in $(comm -23 listed used); do
        brought_by "$package" >brought
        brought_by $(grep -vxF "$package" listed) >brought_by_others
        [[ $(comm -23 brought brought_by_others | comm -12 - used) ]] || complain "$command lists $package, which it does not need"
    done
}

# The packages themselves, and what they depend on.
brought_by() {
    apt-cache depends --recurse --installed --no-{recommends,suggests,conflicts,breaks,replaces,enhances} "$@" |
        sed -n 's/^\([a-z0-9][^ <:]*\).*/\1/p' | sort -u
}

owned_of() { forms | awk 'NR == FNR { files[$1]; next } $2 in files' - owned; }

# How a package may call a file: links lead to it, and /usr may have been left out.
forms() { awk '{ print; sub(/^\/usr/, ""); print }' | { tee paths; xargs realpath -m <paths; } | sort -u; }

# Files of the system that sources include by their own name, not those that come with them.
included() {
    awk 'NR == FNR { names[$1]; next }
        { for (name = $1; sub(/^[^\/]*\//, "", name);) if (name in names) { print $1; next } }' includes files
}

called_programs() { programs <called; }

named_files() {
    programs <words
    { find /usr/share/fonts -name '*.[ot]tf' 2>/dev/null || true; } |
        awk -F '[/.]' 'NR == FNR { words[$0]; next } $(NF - 1) in words' words -
}

programs() { sed 's/^/\/usr\/bin\//' | xargs -d '\n' ls -d 2>/dev/null || true; }

main
