#!/usr/bin/env bash
# Takes the editor's pictures for the README: dark, light, Chinese, and at 200 %. Usage: tests/gui/screenshots.sh [BUILD] [SECONDS]
set -euo pipefail
root=$(dirname "$(readlink -f "$0")")/../..
build=${1:-$root/build/release}
wait=$((${2:-60} * 1000))
pictures=$root/resources/pictures
take() {  # NAME SCALE SIZE ARGS...
    local name=$1 scale=$2 size=$3
    shift 3
    QT_QPA_PLATFORM=offscreen QT_SCALE_FACTOR=$scale "$build/glint" --screenshot "$pictures/$name.jpg" --after "$wait" --size "$size" \
        "$root/scenes/report.json" "$@"
}
take editor 1 1440x900 --select "Glass ball"
take editor_light 1 1440x900 --light --select "Blue box"
take editor_chinese 1 1440x900 --language zh --select "Highlight ball"
take editor_200 2 1100x760 --select "Mirror ball"
