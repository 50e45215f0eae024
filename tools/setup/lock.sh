#!/usr/bin/env bash
# Writes the lock files anew from pyproject.toml, by uv: every version and hash, for every system, and no host.
set -euo pipefail
cd "$(dirname "$0")/../.."

compile() {
    uv pip compile --quiet --no-config --universal --python-version 3.11 --generate-hashes --no-header \
        --no-annotate --no-emit-index-url --no-emit-find-links --upgrade "$@" --group build pyproject.toml
}
compile --extra dev -o requirements/dev.lock
compile --extra film --constraint requirements/dev.lock -o requirements/play.lock
