#!/usr/bin/env bash
# Installs the system libraries that are missing, or says in one line which: system_packages.sh play|test
#
# On Debian and its relatives dpkg is asked, and apt-get installs as root or through a sudo that asks for no password.
# Elsewhere, and on macOS, pyglet finds what the system has; only a missing venv is said.
set -euo pipefail
cd "$(dirname "$0")/../.."

if [ "${SYSTEM_PACKAGES:-install}" = skip ]; then exit 0; fi

packages=(
    libegl1 libegl-mesa0 libgl1 libglx-mesa0 libgl1-mesa-dri  # drawing: EGL without a display, GLX with one
    libfontconfig1 libfreetype6 fonts-dejavu-core             # letters
    libgomp1                                                  # numba's threads
)
if [ "$1" = test ]; then packages+=(xvfb xdotool); fi  # a window to press keys in

python="$(tools/setup/find_python.sh)"
without_venv() { ! "$python" -c 'import ensurepip, venv' 2>/dev/null; }
version="$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')"

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    if without_venv; then
        echo "setup: this Python cannot make environments; install its venv module and ensurepip" >&2
        exit 1
    fi
    if [ "$1" = test ] && [ "$(uname)" = Linux ] && ! { command -v Xvfb && command -v xdotool; } >/dev/null; then
        echo "setup: the tests with a window need Xvfb and xdotool; please install them" >&2
        exit 1
    fi
    exit 0
fi

missing=()
for package in "${packages[@]}"; do
    if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
        missing+=("$package")
    fi
done
if without_venv; then missing+=("python$version-venv"); fi
if [ ${#missing[@]} -eq 0 ]; then exit 0; fi

if [ "$(id -u)" -eq 0 ]; then
    as_root=(env)
elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
    as_root=(sudo -n env)
else
    echo "setup: please run  sudo apt-get install ${missing[*]}  (or SYSTEM_PACKAGES=skip make ... to go without)" >&2
    exit 1
fi

apt() { "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=120 "$@" </dev/null; }
echo "setup: installing ${missing[*]}"
apt install --no-install-recommends "${missing[@]}" >/dev/null 2>&1 || {
    apt update >/dev/null || true
    apt install --no-install-recommends "${missing[@]}" >/dev/null || {
        echo "setup: apt-get could not install: ${missing[*]}; please install them by hand" >&2
        exit 1
    }
}
