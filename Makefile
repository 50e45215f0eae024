# Everything from a fresh machine that has Python 3.11 or newer, make and git: `make play`, `make test`.

PACKAGES := reefgame systems components tools levels assets
PYTHON_SOURCES := $(PACKAGES) tests
LOCKS := $(wildcard requirements/*.lock)
BIN := .venv/bin

export PIP_DISABLE_PIP_VERSION_CHECK := 1

.DEFAULT_GOAL := help
.PHONY: help play test prove bless lint dev lock clean libraries-play libraries-test

help:  ## Say what can be made
	@sed -n 's/^\([a-z]*\):.*## \(.*\)/make \1@\2/p' Makefile | awk -F@ '{printf "%-12s %s\n", $$1, $$2}'

play: libraries-play .venv/play.stamp  ## Play; without a display, film the demonstration dive
	@tools/setup/play.sh

test: lint libraries-test  ## Check style, types and imports, then test the built wheel
	@tools/setup/test_wheel.sh

prove: lint libraries-test  ## As test, with every long case in full
	@tools/setup/test_wheel.sh -m ""

bless: libraries-test .venv/dev.stamp  ## Record golden replays and frames anew; the commit says why
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m pytest -m golden --bless

lint: .venv/dev.stamp  ## Check style and types
	@$(BIN)/ruff check $(PYTHON_SOURCES)
	@$(BIN)/ruff format --check $(PYTHON_SOURCES)
	@$(BIN)/mypy $(PYTHON_SOURCES)

dev: libraries-test .venv/dev.stamp  ## Make the developers' environment

lock:  ## Write the lock files anew (needs uv)
	@tools/setup/lock.sh

clean:  ## Remove what was built, and the environment
	rm -rf .venv build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis

libraries-play libraries-test: libraries-%:
	@tools/setup/system_packages.sh $*

# The project itself is installed from its folder: `make play` shows an edited level at once. The tests have the wheel.
.venv/%.stamp: pyproject.toml $(LOCKS) | libraries-play
	@tools/setup/environment.sh $*
	@$(BIN)/python -m pip install --quiet --no-index --no-deps --no-build-isolation --editable .
	@touch $@
