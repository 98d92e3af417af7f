# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""check_exports.py LIST LIBRARY HEADER...: the functions that the headers declare, the export list and the symbols that
the library defines are the same. With LIBRARY '-', only headers and list are compared; with --update, LIST is rewritten
from the headers."""
import re
import subprocess
import sys


def declared(headers):
    names = set()
    for header in headers:
        with open(header, encoding="utf-8") as file:
            text = re.sub(r"/\*.*?\*/|//[^\n]*", " ", file.read(), flags=re.S)
        text = re.sub(r"^[ \t]*#.*(?:\\\n.*)*", "", text, flags=re.M)
        names.update(re.findall(r"\bTYN_(?:IO_)?API\b[^;{]*?\b(tyn_\w+)\s*\(", text))
    return names


def listed(path):
    with open(path, encoding="utf-8") as file:
        return {name for name in (line.split("#")[0].strip() for line in file) if name}


def defined(library):
    output = subprocess.run(["nm", "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    symbols = [line.split() for line in output.splitlines()]
    # type A is the version node itself; coverage and sanitizer runtimes add names of their own
    return {s[2].split("@")[0] for s in symbols if len(s) == 3 and s[1] != "A"}


def compare(what, left, right):
    for name in sorted(left - right):
        print(f"{name}: {what}")
    return bool(left - right)


def main(arguments):
    update = "--update" in arguments
    list_path, library, *headers = [a for a in arguments if a != "--update"]
    wanted = declared(headers)
    if update:
        with open(list_path, "w", encoding="utf-8") as file:
            file.write("".join(name + "\n" for name in sorted(wanted)))
    names = listed(list_path)
    bad = compare("declared in a public header but not in the export list", wanted, names)
    bad |= compare("in the export list but in no public header", names, wanted)
    if library != "-":
        symbols = defined(library)
        bad |= compare("in the export list but not defined by the library", names, symbols)
        bad |= compare("visible in the library but not in the export list", symbols, names)
    if not bad:
        print(f"{len(names)} exported functions")
    return bad or not names


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
