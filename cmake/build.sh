# SPDX-License-Identifier: BSD-3-Clause
# Functions for ./run and ./test, which set `root`: configure and build a preset, and show how far the build is.

# show_progress WHAT: reads ninja's output, passes it on, and reports on stderr how many steps are done: on a terminal in
# one line that is overwritten, otherwise in one line a minute.
show_progress() {
    local what=$1 line progress="" said=$SECONDS
    while IFS= read -r line; do
        printf '%s\n' "$line"
        [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
        progress="$what: ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
        if [ -t 2 ]; then
            printf '\r\033[K%s' "$progress" >&2
        elif ((SECONDS - said >= ${TIRETHERM_PROGRESS_SECONDS:-60})); then
            printf '%s\n' "$progress" >&2
            said=$SECONDS
        fi
    done
    if [ -t 2 ] && [ -n "$progress" ]; then
        printf '\r\033[K' >&2
    fi
}

# configure PRESET: where the build folder is new, or older than the presets or the packages that are installed. A folder made for
# another place of the tree (a moved or mounted copy) is started anew.
configure() {
    local build="$root/build/$1" fresh=""
    grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt" || fresh="--fresh"
    if [ -n "$fresh" ] || [ ! "$build/build.ninja" -nt "$root/CMakePresets.json" ] ||
        [ ! "$build/build.ninja" -nt /var/lib/dpkg/status ]; then
        (cd "$root" && cmake --preset "$1" $fresh) && touch "$build/build.ninja"
    fi
}

# build PRESET WHAT [targets]: all targets unless some are named; WHAT stands before the numbers of the progress.
# The whole output is in build/PRESET/build.log; when the build fails, what failed is printed. One build of a preset at a
# time, also when several are started together.
build() {
    local preset=$1 what=$2 log="$root/build/$1/build.log"
    shift 2
    mkdir -p "$root/build/$preset"
    (
        flock 9
        configure "$preset" >"$log" 2>&1 &&
            NINJA_STATUS='[%f/%t] ' ninja -C "$root/build/$preset" "$@" 2>&1 | show_progress "$what" >>"$log" &&
            exit
        grep -v '^\[[0-9]*/[0-9]*\] ' "$log" >&2 || true
        echo "the build failed; its whole log is $log" >&2
        exit 1
    ) 9>"$root/build/$preset/.lock" </dev/null
}
