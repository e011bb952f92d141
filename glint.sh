#!/usr/bin/env bash
# Installs what Glint needs (Debian 12), builds it, and runs it. `./glint.sh help` lists the commands.
set -euo pipefail

root=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
release=$root/build/release
# What libraries of the system leak; our own leaks still count.
leak_suppressions=suppressions=$root/tests/support/lsan.supp:print_suppressions=0
case ${GLINT_GUI:-ON} in
    OFF | off | 0 | no) gui_option=-DGLINT_GUI=OFF ;;
    *) gui_option=-DGLINT_GUI=ON ;;
esac

# One package a line, with the reason. The only list of what Glint needs.
core_packages=(
    g++                   # compiler, C++20
    cmake                 # build description
    ninja-build           # build tool
    libglm-dev            # vectors
    libhwy-dev            # SIMD with run-time dispatch
    libopenexr-dev        # EXR pictures
    libopenimageio-dev    # every other picture format
    nlohmann-json3-dev    # scene files
    libcli11-dev          # command lines
    libgtest-dev          # tests
    libgmock-dev          # tests: matchers
    libembree-dev         # glint-bench: what our rays are measured against
    openimageio-tools     # tests: layers as other programs read them
)
gui_packages=(
    qt6-base-dev          # the window
    qt6-svg-dev           # icons
    qt6-l10n-tools        # translations: lrelease, lupdate
    qt6-tools-dev         # translations: their CMake package
    qt6-translations-l10n # Qt's own texts in other languages
    libgl-dev             # named by Qt's CMake package
    fonts-dejavu-core     # a font, should the system have none
    fonts-noto-cjk        # Chinese
)
full_packages=(
    clang                 # fuzzing needs libFuzzer
    libclang-rt-14-dev    # libFuzzer and the sanitizers' run time
)

usage() {
    cat <<'TEXT'
usage: ./glint.sh [SCENE]         build, then open the editor on SCENE (default: scenes/report.json);
                                  without a display, render it to report.png in the current folder
       ./glint.sh build           build only, into build/release
       ./glint.sh render ARGS     glint-render: SCENE -o PICTURE [--spp N] ... (render --help)
       ./glint.sh test [--full]   build and run every test; --full: long forms, sanitizers, fuzzing
       ./glint.sh numbers        the full numeric tests of geometry; their counts into tests/numeric/README.md
       ./glint.sh closed-forms    every closed-form picture against its formula; the table into tests/render/README.md
       ./glint.sh bench ARGS      glint-bench: measure (bench --help); bench window SCENE: the editor's window
       ./glint.sh help            this text

Missing packages are installed with apt (as root or by sudo). GLINT_GUI=OFF leaves out the editor and Qt.
TEXT
}

say() { printf 'glint: %s\n' "$*" >&2; }

fail() {
    say "$1"
    exit "${2:-1}"
}

gui_wanted() { [[ $gui_option == *=ON ]]; }

# Sets `missing` to those of the given packages that are not installed.
find_missing() {
    local known package
    known=$'\n'$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)$'\n'
    missing=()
    for package in "$@"; do
        [[ $known == *$'\n'"installed $package"$'\n'* ]] || missing+=("$package")
    done
}

# Installs those of the given packages that are missing; no network and no root where none is.
install_packages() {
    local -a missing as_root=() apt
    if ! command -v dpkg-query >/dev/null; then
        say "no dpkg here: taking it that these are installed: $*"
        return
    fi
    find_missing "$@"
    ((${#missing[@]})) || return 0
    if ((EUID != 0)); then
        command -v sudo >/dev/null ||
            fail "as root, install first: apt-get install --no-install-recommends ${missing[*]}"
        as_root=(sudo)
    fi
    apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -o DPkg::Lock::Timeout=600)
    say "installing ${missing[*]}"
    {
        # Package lists may be absent (containers) or too old (the second try).
        apt-get install -s --no-install-recommends "${missing[@]}" >/dev/null 2>&1 || "${apt[@]}" update
        "${apt[@]}" install --no-install-recommends "${missing[@]}" ||
            { "${apt[@]}" update && "${apt[@]}" install --no-install-recommends "${missing[@]}"; }
    } >&2 || fail "apt could not install ${missing[*]}"
}

install_needed() {
    local -a packages=("${core_packages[@]}")
    ! gui_wanted || packages+=("${gui_packages[@]}")
    install_packages "${packages[@]}"
}

# configure PRESET [OPTION...]: only if there is no build folder for it, or one of another place or another choice.
configure() {
    local preset=$1 folder=$root/build/$1 option
    local -a fresh=()
    shift
    local cache=$folder/CMakeCache.txt current=1
    [[ $folder/build.ninja -nt $root/CMakePresets.json ]] || current=0
    for option in "$@"; do
        grep -qx -- "${option#-D}" <(sed 's/:[A-Z]*=/=/' "$cache" 2>/dev/null) || current=0
    done
    if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
        fresh=(--fresh)
        current=0
    fi
    ((current)) || cmake "${fresh[@]}" -S "$root" --preset "$preset" "$@" >&2
}

# build PRESET [OPTION...]
build() {
    configure "$@"
    cmake --build "$root/build/$1" >&2
}

build_release() {
    install_needed
    build release "$gui_option"
}

open_scene() {
    local scene=${1:-$root/scenes/report.json}
    build_release
    if gui_wanted && [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
        exec "$release/glint" "$scene"
    fi
    say "no display: rendering $scene"
    "$release/glint-render" "$scene" -o "$PWD/report.png"
    printf '%s\n' "$PWD/report.png"
}

run_ctest() {
    local preset=$1
    shift
    ctest --test-dir "$root/build/$preset" --output-on-failure --no-tests=error -j "$(nproc)" "$@"
}

# stage NAME COMMAND...: runs it, prints its duration, and notes a failure for the end.
stage() {
    local name=$1 start=$SECONDS result=passed
    shift
    say "$name ..."
    # In the background, because a command within a condition would run on after errors.
    "$@" &
    wait $! || { result=FAILED && failed_stages+=("$name"); }
    printf '%s: %s after %d s\n' "$name" "$result" $((SECONDS - start))
}

test_sanitizer() {
    build "$@"
    LSAN_OPTIONS=$leak_suppressions run_ctest "$1" -LE full
}

# Each fuzz target for 60 s (GLINT_FUZZ_SECONDS), starting from its corpus; new inputs stay in the build folder.
fuzz() {
    build fuzz
    export LSAN_OPTIONS=$leak_suppressions
    local target name leaks
    for target in "$root"/build/fuzz/glint-fuzz-*; do
        [[ -x $target ]] || fail "no fuzz targets in build/fuzz"
        name=${target##*/glint-fuzz-}
        mkdir -p "$root/build/fuzz/corpus/$name"
        leaks=1
        [[ $name != image ]] || leaks=0 # the check itself fails among the image library's threads
        (cd "$root/build/fuzz" && "$target" -detect_leaks=$leaks -max_total_time="${GLINT_FUZZ_SECONDS:-60}" -timeout=1 -rss_limit_mb=4096 \
            -print_final_stats=1 "corpus/$name" "$root/tests/fuzz/corpus/$name")
    done
}

# The plain run comes last, so that ctest's summary ends the output.
run_tests() {
    local full=0 start=$SECONDS
    local -a failed_stages=()
    case ${1:-} in
        --full) full=1 ;;
        '') ;;
        *) fail "unknown option $1; usage: ./glint.sh test [--full]" ;;
    esac
    build_release
    printf 'build: passed after %d s\n' $((SECONDS - start))
    if ((full)); then
        install_packages "${full_packages[@]}"
        stage "address and undefined sanitizers" test_sanitizer asan "$gui_option"
        stage "thread sanitizer" test_sanitizer tsan
        stage "fuzzing" fuzz
        printf 'before the long tests: %d s\n' $((SECONDS - start))
        ((${#failed_stages[@]} == 0)) || printf 'FAILED: %s\n' "${failed_stages[@]}"
        GLINT_FULL=1 run_ctest release && ((${#failed_stages[@]} == 0))
    else
        run_ctest release -LE full
    fi
}

# The full forms of the geometry tests, one after the other, and the tables of tests/numeric/README.md.
run_numbers() {
    build_release
    local record=$release/numbers.tsv tests=$release/tests
    rm -f "$record"
    export GLINT_FULL=${GLINT_FULL:-1} GLINT_RECORD=$record
    local geometry='SphereFull.*:ShapesFull.*:TorusFull.*:AcneFull.*:ContactFull.*:LeaksFull.*:AnyHitFull.*:ShapeListsFull.*:ScaleFull.*:SolidAngleFull.*'
    # The table is written whatever fails, and says so.
    local failed=0
    "$tests/glint_tests_numeric" --gtest_filter="$geometry" || failed=1
    "$tests/glint_tests_render" --gtest_filter='MediaWalkFull.*' || failed=1
    "$tests/glint-numeric-table" "$root/tests/numeric/README.md" "$record" || failed=1
    ((failed == 0)) || fail "tests failed; see above and tests/numeric/README.md"
}

# The closed forms of scenes/verify; their table into tests/render/README.md. GLINT_FULL=1: 16 times the samples.
run_closed_forms() {
    build_release
    local readme=$root/tests/render/README.md rows=$release/closed-forms.rows failed=0
    rm -f "$rows"
    GLINT_CLOSED_FORMS=$rows "$release/tests/glint_tests_render" --gtest_filter='*Verify.PictureIs*' || failed=1
    sort -V -o "$rows" "$rows"
    sed -i -e '/<!-- closed forms -->/,/<!-- end of closed forms -->/{//!d}' "$readme"
    sed -i -e "/<!-- closed forms -->/r /dev/stdin" "$readme" < <(
        printf '| | Scene | exact | mean | error | σ |\n|---|---|---|---|---|---|\n'
        cat "$rows"
    )
    ((failed == 0)) || fail "a picture is not its closed form; see above"
}

command=${1:-}
(($# == 0)) || shift
case $command in
    build) build_release ;;
    render)
        build_release
        exec "$release/glint-render" "$@"
        ;;
    test) run_tests "$@" ;;
    numbers) run_numbers ;;
    closed-forms) run_closed_forms ;;
    bench)
        build_release
        if [[ ${1:-} == window ]]; then
            shift
            exec "$release/glint-window-bench" "$@"
        fi
        exec "$release/glint-bench" "$@"
        ;;
    help | -h | --help) usage ;;
    '') open_scene ;;
    *)
        [[ -f $command ]] || {
            usage >&2
            fail "no command and no scene file: $command"
        }
        (($# == 0)) || fail "one scene at a time; usage: ./glint.sh [SCENE]"
        open_scene "$command"
        ;;
esac
