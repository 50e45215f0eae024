#!/usr/bin/env bash
# Plays: the game where there is a display, else the recorded demonstration dive, into a film and a picture.
set -euo pipefail
cd "$(dirname "$0")/../.."
reefgame=".venv/bin/reefgame"

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || [ "$(uname)" = Darwin ]; then
    exec "$reefgame" play
fi

film="build/first_dive.mp4"
picture="build/first_dive.png"
mkdir -p build
echo "There is no display: the demonstration dive is played without one, into a film."
"$reefgame" replay levels/demonstration.replay --headless --video "$film" --picture "$picture"
echo "The film is $PWD/$film"
echo "The picture is $PWD/$picture"
