#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""check_habits.py SOURCE_DIR: every source of ours has an SPDX line, and every folder an owner in .github/CODEOWNERS.
Exit codes: 0 fine, 1 not, 3 not a checkout."""
import pathlib
import subprocess
import sys

SPDX = "SPDX-License-Identifier: Apache-2.0"
# Texts and data, which LICENSE covers, and files that have no place for a comment or are another's format.
WITHOUT = (".md", ".toml", ".json", ".ipynb", ".png", ".exr", "LICENSE", "report/assets/page.html", "packaging/debian/changelog.in",
           "packaging/debian/copyright", "packaging/debian/copyright-exact")
DATA = ("fuzz/corpus/",)


def lacks_spdx(name, head):
    return not name.endswith(WITHOUT) and not name.startswith(DATA) and SPDX not in head


def owned_folders(text):
    lines = [line.split() for line in text.splitlines() if line.strip() and not line.startswith("#")]
    return {words[0].strip("/") for words in lines if words[0].startswith("/") and len(words) > 1}


def problems(files, owned):
    folders = {name.split("/")[0] for name in files if "/" in name and not name.startswith(".")}
    yield from (f"{name} has no SPDX line" for name, head in sorted(files.items()) if lacks_spdx(name, head))
    yield from (f"{folder}/ has no owner in .github/CODEOWNERS" for folder in sorted(folders - owned))
    yield from (f".github/CODEOWNERS names /{folder}/, which is not there" for folder in sorted(owned - folders))


def self_test():
    """The check itself must be able to fail."""
    assert list(problems({"a/x.cpp": "int x;"}, {"a"}))
    assert list(problems({"a/x.cpp": SPDX}, set()))
    assert list(problems({"a/x.cpp": SPDX}, {"a", "b"}))
    assert not list(problems({"a/x.cpp": SPDX, "README.md": ""}, owned_folders("* @t\n/a/ @t\n")))


def main():
    self_test()
    root = pathlib.Path(sys.argv[1])
    listed = subprocess.run(["git", "-C", str(root), "ls-files"], capture_output=True, text=True)
    if listed.returncode != 0:
        print("check_habits: not a checkout: nothing was looked at", file=sys.stderr)
        return 3
    names = [name for name in listed.stdout.splitlines() if (root / name).is_file()]
    files = {name: (root / name).read_bytes()[:600].decode(errors="replace") for name in names}
    found = list(problems(files, owned_folders((root / ".github/CODEOWNERS").read_text())))
    print("\n".join(found) or f"{len(files)} files have their licence, {len({n.split('/')[0] for n in files if '/' in n})} folders their owner")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
