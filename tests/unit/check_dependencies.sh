#!/bin/sh
# usage: check_dependencies.sh TRACER_SOURCES TRACER_LIBRARY BINARY
# Fails if the tracer includes or calls Qt, or includes OpenImageIO outside of io/, or if BINARY loads either.
set -u
sources=$1 library=$2 binary=$3
status=0

reject() {
    echo "$1:"
    echo "$2"
    status=1
}

found=$(grep -rnE '#include *[<"](Q[A-Z]|Qt)' "$sources") && reject "Qt included" "$found"
found=$(grep -rn '#include *[<"]OpenImageIO' "$sources" | grep -v '/io/image_module') &&
    reject "OpenImageIO included outside of its module" "$found"
found=$(nm -C --undefined-only "$library" 2>/dev/null | grep -E ' (Q[A-Z][A-Za-z]+::|OpenImageIO)') &&
    reject "undefined symbols of Qt or OpenImageIO in $library" "$found"
found=$(ldd "$binary" | grep -E 'libQt|libOpenImageIO') && reject "$binary loads" "$found"
exit $status
