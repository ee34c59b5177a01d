#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# test_container.sh SOURCE_DIR: builds the Containerfile from what is committed and validates a scene in its image. The base image is the
# one podman has, else one made from the archive by mmdebstrap: nothing is pulled. Compiled objects come from ccache where its versions
# are the same. Without it the Containerfile could name packages, presets or files that are no more.
# Exit codes: 0 fine, 1 not, 3 no root, no podman or no archive here. Two gigabytes, and the time of a build.
set -euo pipefail
source_dir=$(realpath "$1")
fail() { echo "test_container: $*" >&2; exit 1; }
cannot() { echo "test_container: $*: nothing was tried" >&2; exit 3; }
command -v podman >/dev/null || cannot "podman is not installed"
[ "$(id -u)" -eq 0 ] || cannot "not root"
work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT

base=docker.io/library/debian:bookworm
if ! podman image exists "$base"; then
  command -v mmdebstrap >/dev/null || cannot "there is no image $base and no mmdebstrap to make one"
  mmdebstrap --mode=root --variant=apt --components=main bookworm "$work/base.tar" >"$work/base.log" 2>&1 || { tail -5 "$work/base.log"; cannot "no Debian root"; }
  podman import "$work/base.tar" "$base" >/dev/null 2>&1 || cannot "podman imports no image"
fi
podman image exists "$base-slim" || podman tag "$base" "$base-slim"

git clone -q "$source_dir" "$work/source"
# chroot needs no container runtime of the kernel's, so this runs in virtual machines and containers, too.
build=(podman build --isolation=chroot --network=host)
cache=$(ccache --get-config cache_dir 2>/dev/null) && [ -d "$cache" ] &&
  build+=(-v "$cache:/ccache" --env CCACHE_DIR=/ccache --env CCACHE_BASEDIR=/source --env CMAKE_CXX_COMPILER_LAUNCHER=ccache)
"${build[@]}" -t umbrameter-test "$work/source" >"$work/build.log" 2>&1 || { tail -30 "$work/build.log"; fail "the Containerfile does not build"; }

mkdir "$work/use"
cat >"$work/use/Containerfile" <<'END'
FROM umbrameter-test
WORKDIR /work
RUN umbrameter doctor && umbrameter validate plate --technique hard --width 96 --height 54 --out out && test -s out/report.html
RUN python3 -c 'import umbrameter as um; print(um.truth(um.load_scene("plate"), width=32, height=18, samples=16)["visibility"].mean())'
END
podman build --isolation=chroot --network=host --no-cache "$work/use" || fail "the image does not work"
podman image inspect umbrameter-test --format '{{.Config.Entrypoint}}' | grep -q umbrameter || fail "the image does not start umbrameter"
podman rmi -f umbrameter-test >/dev/null 2>&1 || true
echo "test_container: fine"
