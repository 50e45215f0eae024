#!/usr/bin/env bash
# Builds the wheel, installs it beside the locked packages and runs its tests: test_wheel.sh [PYTEST ARGUMENT]...
#
# The wheel gets an environment of its own that borrows the packages of .venv by a path line. Path lines found there
# are not followed in turn, so a project installed from its folder in .venv cannot hide the wheel. The tests run
# outside the checkout; tests/conftest.py refuses to start unless every package comes from the wheel.
set -euo pipefail
cd "$(dirname "$0")/../.."
checkout="$PWD"
python=".venv/bin/python"
wheel_env="$checkout/build/wheel-env"

rm -rf build/wheel build/wheel-env build/lib
"$python" -m pip --disable-pip-version-check wheel --quiet --no-index --no-deps --no-build-isolation -w build/wheel .
"$python" -m venv --without-pip build/wheel-env
"$python" -m pip --disable-pip-version-check --python "$wheel_env/bin/python" \
    install --quiet --no-index --no-deps build/wheel/*.whl
site_packages='import sysconfig; print(sysconfig.get_path("purelib"))'
"$python" -c "$site_packages" > "$("$wheel_env/bin/python" -c "$site_packages")/locked.pth"

mkdir -p build/test-run
cd build/test-run
unset PYTHONPATH
export REEFGAME_TEST_WHEEL=1 PYTHONSAFEPATH=1 OPENBLAS_NUM_THREADS=1
exec "$wheel_env/bin/python" -m pytest -n logical --dist loadfile --rootdir "$checkout" -c "$checkout/pyproject.toml" \
    -o cache_dir="$checkout/build/pytest-cache" "$@" "$checkout/tests"
