#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# test_package.sh SOURCE_DIR BUILD_DIR: makes the Debian packages, unpacks them into an empty root, hides sources and build
# folder, and works from there: a validation, a project that links the libraries by CMake and by pkg-config.
# Without it, an installed program could need its checkout, or a package could lack a file.
set -euo pipefail
source_dir=$(realpath "$1")
build_dir=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "test_package: $*" >&2; exit 1; }

(cd "$build_dir" && cpack -G DEB -B "$work/packages" >"$work/cpack.log" 2>&1) || { cat "$work/cpack.log"; fail "cpack failed"; }
root=$work/root
mkdir "$root"
debs=("$work"/packages/*.deb)
for deb in "${debs[@]}"; do
  dpkg-deb -x "$deb" "$root"
  echo "test_package: $(basename "$deb"): $(dpkg-deb -f "$deb" Depends)"
done
dpkg-deb -f "$work"/packages/umbrameter_*.deb Depends | grep -q libembree3-3 || fail "shlibdeps found no Embree"
if command -v lintian >/dev/null; then
  # Static libraries are compiled without link-time optimisation; there is no bug number to close.
  lintian --fail-on error,warning --suppress-tags bad-distribution-in-changes-file "${debs[@]}" || fail "lintian complains"
else
  echo "test_package: lintian is not installed: not looked at" >&2
fi
program=$root/usr/bin/umbrameter
! grep -qaF "$source_dir" "$program" || fail "$program holds the path of its sources"
! grep -rqF "$source_dir" "$root/usr/lib/cmake" "$(find "$root/usr/lib" -name pkgconfig)" || fail "package files hold the path of the sources"

# Where the kernel allows it, the checkout and the build folder are not even there.
hide=()
if unshare --mount --map-root-user true 2>/dev/null; then
  hide=(unshare --mount --map-root-user bash -c
        'mount -t tmpfs none "$0" && { [ ! -d "$1" ] || mount -t tmpfs none "$1"; } && shift && exec "$@"' "$source_dir" "$build_dir")
else
  echo "test_package: mount namespaces are not allowed here: the checkout stays visible" >&2
fi
cd "$work"
run() { env -i HOME="$work" PATH=/usr/bin:/bin "${hide[@]}" "$@"; }

[ "$(run "$program" --version | cut -d' ' -f2)" = "$(dpkg-deb -f "$work"/packages/umbrameter_*.deb Version)" ] || fail "versions differ"
run "$program" scene list --json >scenes.json
python3 - "$root" scenes.json <<'PY' || fail "scenes come from elsewhere"
import json, sys
scenes = json.load(open(sys.argv[2]))["scenes"]
assert len(scenes) >= 26, len(scenes)
assert all(s["file"].startswith(sys.argv[1] + "/usr/share/umbrameter/scenes/library/") for s in scenes), scenes[0]
PY
if run "$program" doctor >doctor.txt 2>&1; then
  run "$program" validate plate --technique hard --width 96 --height 54 --out out --json >validate.json || fail "validate failed"
  python3 -c 'import json; r = json.load(open("validate.json")); print("test_package: validated:", str(r)[:120])'
  [ -s out/report.html ] || fail "validate left no report"
else
  rc=$?
  [ $rc -eq 3 ] || { cat doctor.txt; fail "doctor ended with $rc"; }
  echo "test_package: no usable GL here: nothing was validated" >&2
fi

# Another project uses the libraries, by CMake and by pkg-config.
cp -r "$source_dir/tests/package/consumer" "$work/consumer"
run cmake -S consumer -B consumer-build -DCMAKE_PREFIX_PATH="$root/usr" -DCMAKE_BUILD_TYPE=Release >cmake.log 2>&1 &&
  run cmake --build consumer-build >>cmake.log 2>&1 || { cat cmake.log; fail "find_package(umbrameter) failed"; }
run consumer-build/consumer || fail "the project that CMake linked fails"
pc=(env PKG_CONFIG_PATH="$(dirname "$(find "$root/usr/lib" -name umbrameter.pc)")" pkg-config)
read -ra flags < <(run "${pc[@]}" --cflags umbrameter)
read -ra libraries < <(run "${pc[@]}" --libs umbrameter)
run c++ -std=c++20 -DDATA_FOLDER="\"$root/usr/share/umbrameter\"" "${flags[@]}" consumer/consumer.cpp "${libraries[@]}" -o by-pkg-config ||
  fail "pkg-config's flags do not link"
run ./by-pkg-config || fail "the project that pkg-config linked fails"
