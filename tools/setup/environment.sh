#!/usr/bin/env bash
# Makes .venv hold what a lock file names, and nothing else: environment.sh play|dev
#
# The environment is made afresh when a lock changed since it was made, or when its Python is gone. Every package is
# checked against the hash in the lock.
set -euo pipefail
cd "$(dirname "$0")/../.."

lock="requirements/$1.lock"
made=.venv/made-from
locks="$(cat requirements/*.lock | cksum)"

if ! .venv/bin/python -c 'import pip' 2>/dev/null || [ "$(cat "$made" 2>/dev/null)" != "$locks" ]; then
    python="$(tools/setup/find_python.sh)"
    echo "setup: making .venv with $("$python" --version)"
    "$python" -m venv --clear .venv
fi
echo "setup: installing $lock"
.venv/bin/python -m pip --disable-pip-version-check install --quiet --require-hashes -r "$lock"
echo "$locks" > "$made"
