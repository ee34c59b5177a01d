#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# test_clean_root.sh BUILD_DIR: makes the Debian packages, installs them with apt into a Debian 12 root that holds nothing else (by
# mmdebstrap, from the archive), and works there: doctor, a validation, the exact oracle, and README's Python example. The last stage of
# the Containerfile does the same. Without it a package could lack a dependency that every developer's machine has.
# Exit codes: 0 fine, 1 not, 3 no root, no mmdebstrap or no archive here. A gigabyte and some minutes.
set -euo pipefail
build_dir=$(realpath "$1")
source_dir=$(realpath "$(dirname "$0")/../..")
fail() { echo "test_clean_root: $*" >&2; exit 1; }
cannot() { echo "test_clean_root: $*: nothing was tried" >&2; exit 3; }
command -v mmdebstrap >/dev/null || cannot "mmdebstrap is not installed"
[ "$(id -u)" -eq 0 ] || cannot "not root"
work=$(mktemp -d)
root=$work/root
clean_up() {
  for place in proc dev/shm; do mountpoint -q "$root/$place" && umount "$root/$place"; done
  rm -rf --one-file-system "$work"
}
trap clean_up EXIT

(cd "$build_dir" && cpack -G DEB -B "$work/packages" >"$work/cpack.log" 2>&1) || { cat "$work/cpack.log"; fail "cpack failed"; }
mmdebstrap --mode=root --variant=apt --components=main bookworm "$root" >"$work/root.log" 2>&1 || { tail -5 "$work/root.log"; cannot "no Debian root"; }
mkdir "$root/packages"
cp "$work"/packages/umbrameter_*.deb "$work"/packages/umbrameter-exact_*.deb "$work"/packages/python3-umbrameter_*.deb "$root/packages"
mount -t proc proc "$root/proc" || cannot "/proc cannot be mounted"
mount -t tmpfs tmpfs "$root/dev/shm" || cannot "/dev/shm cannot be mounted"
inside() { chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
inside sh -c 'apt-get update -qq && apt-get install -y -qq --no-install-recommends /packages/*.deb' >"$work/install.log" 2>&1 ||
  { tail -20 "$work/install.log"; fail "the packages do not install"; }
! [ -e "$root$source_dir" ] || fail "the checkout is in the root"

inside umbrameter doctor || fail "doctor complains"
inside sh -c 'cd /root && umbrameter validate plate --technique hard --technique pcss --width 96 --height 54 --out out' || fail "validate failed"
[ -s "$root/root/out/report.html" ] || fail "validate left no report"
inside sh -c 'cd /root && umbrameter reference plate --width 64 --height 36 --exact-check 20 -o ref.exr' || fail "the exact oracle failed"
python3 - "$source_dir/README.md" >"$root/root/example.py" <<'PY'
import re, sys
print(re.search(r"^```python\n(.*?)^```", open(sys.argv[1]).read(), re.M | re.S)[1])
PY
inside sh -c 'cd /root && python3 example.py' || fail "README's Python example failed"
inside env -C /root python3 -c '
import umbrameter as um
try:
    um.frames("out")
except um.MachineError as error:
    assert "python3-pandas" in str(error), error
else:
    raise SystemExit("pandas came unasked")' || fail "the module does not say what data frames need"
inside apt-get remove -y -qq umbrameter >/dev/null 2>&1 || fail "the packages cannot be removed"
[ ! -e "$root/usr/share/umbrameter" ] || fail "files stay behind"
echo "test_clean_root: fine"
