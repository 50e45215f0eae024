"""What every test stands on: its own user folders, the marks, `--bless`, proof of the wheel."""

import os
from pathlib import Path

import pytest
from hypothesis import settings

import assets
import components
import levels
import reefgame
import systems
import tools

# Tests never time: a first call may compile a kernel.
settings.register_profile("reefgame", deadline=None, derandomize=True)
settings.load_profile("reefgame")

CHECKOUT = Path(__file__).resolve().parents[1]
PACKAGES = (reefgame, systems, components, levels, assets, tools)


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add `--bless`: tests marked `golden` write what they compare with, instead of comparing."""
    parser.addoption("--bless", action="store_true", help="record golden replays and frames anew")


def pytest_configure(config: pytest.Config) -> None:
    """Name the marks."""
    config.addinivalue_line("markers", "prove: a long case, run by `make prove` alone")
    config.addinivalue_line("markers", "golden: compares with a file that `make bless` writes")


def pytest_sessionstart() -> None:
    """Refuse to start where the wheel is asked for and any package comes from elsewhere."""
    if os.environ.get("REEFGAME_TEST_WHEEL") != "1":
        return
    for package in PACKAGES:
        if "site-packages" not in Path(str(package.__file__)).parts:
            pytest.exit(f"{package.__name__} is {package.__file__}, not the wheel's", returncode=3)


@pytest.fixture(scope="session")
def checkout() -> Path:
    """The folder that holds pyproject.toml and tests/."""
    return CHECKOUT


@pytest.fixture(scope="session")
def installed() -> Path:
    """The folder that the packages under test were imported from."""
    return Path(str(reefgame.__file__)).parents[1]


@pytest.fixture
def bless(request: pytest.FixtureRequest) -> bool:
    """Whether a golden file is to be written and not compared with."""
    return bool(request.config.getoption("--bless"))


@pytest.fixture(scope="session")
def artifacts() -> Path:
    """Where a failed golden frame leaves its picture and the difference: build/frames."""
    folder = CHECKOUT / "build" / "frames"
    folder.mkdir(parents=True, exist_ok=True)
    return folder


@pytest.fixture(autouse=True)
def user_folders(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Give every test saves and settings of its own; the cache stays shared, for the kernels."""
    home = tmp_path_factory.mktemp("user")
    for name in ("DATA", "CONFIG", "STATE"):
        monkeypatch.setenv(f"XDG_{name}_HOME", str(home / name.lower()))
    return home
