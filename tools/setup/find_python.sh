#!/usr/bin/env bash
# Prints a Python of 3.11 or newer: $PYTHON if set, else the first that will do; else says what is wanted.
set -euo pipefail

for candidate in ${PYTHON:-python3 python3.13 python3.12 python3.11 python3.14 python}; do
    if "$candidate" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
        command -v "$candidate"
        exit 0
    fi
done
echo "setup: Python 3.11 or newer is needed and none was found; install one, or name it: make PYTHON=..." >&2
exit 1
