"""Settings come back as saved; what is wrong is named by its place, and never lost."""

import json
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from reefgame.settings import (
    LIVE_FISHES,
    QUALITIES,
    RENDER_SCALES,
    Settings,
    load,
    save,
    settings_path,
)

ANY = st.builds(
    Settings,
    mouse_sensitivity=st.floats(0.2, 3.0),
    invert_pitch=st.booleans(),
    quality=st.sampled_from(QUALITIES),
    render_scale=st.sampled_from(RENDER_SCALES),
    fullscreen=st.booleans(),
    live_physics=st.sampled_from(LIVE_FISHES),
)


@given(settings=ANY)
def test_settings_come_back_as_saved(
    tmp_path_factory: pytest.TempPathFactory, settings: Settings
) -> None:
    path = tmp_path_factory.mktemp("settings") / "deep" / "settings.json"
    assert save(settings, path) is None
    assert load(path) == (settings, [])


def test_no_file_means_defaults_in_the_users_folder(user_folders: Path) -> None:
    assert load() == (Settings(), [])
    assert user_folders in settings_path().parents


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ('{"quality": "ultra"}', "1:2: quality must be"),
        ('{\n  "render_scale": 60}', "2:3: render_scale must be 50 or 75 or 100"),
        ('{"render_scale": true}', "1:2: render_scale must be"),
        ('{"mouse_sensitivity": "fast"}', "1:2: mouse_sensitivity must be a number"),
        ('{"mouse_sensitivity": 1e400}', "1:2: mouse_sensitivity must be a number"),
        ('{"mouse_sensitivity": NaN}', "1:1: NaN is no number"),
        ('{"colour": 1}', "1:2: unknown setting 'colour'"),
        ('{"quality": \n "low"', "2:7: Expecting ',' delimiter"),
        ("[]", "1:1: a JSON object is expected"),
        ("", "1:1: Expecting value"),
        ("[" * 100_000, "1:1: "),
        ("\x00", "1:1: "),
    ],
)
def test_a_bad_file_is_named_by_place_and_gives_defaults(
    tmp_path: Path, text: str, line: str
) -> None:
    path = tmp_path / "settings.json"
    path.write_text(text, encoding="utf-8")
    settings, wrong = load(path)
    assert settings == Settings()
    assert len(wrong) == 1
    assert wrong[0].startswith(f"{path}:{line}")
    assert "\n" not in wrong[0]
    assert path.read_text(encoding="utf-8") == text


def test_good_values_beside_a_bad_one_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "settings.json"
    path.write_text('{"quality": "low", "render_scale": 3, "fullscreen": true}')
    settings, wrong = load(path)
    assert settings == Settings(quality="low", fullscreen=True)
    assert len(wrong) == 1


def test_a_bad_file_is_kept_beside_the_new_one(tmp_path: Path) -> None:
    path = tmp_path / "settings.json"
    path.write_bytes(b"\xff\xfe not settings")
    assert save(Settings(quality="low"), path) is None
    assert load(path) == (Settings(quality="low"), [])
    assert (tmp_path / "settings.json.bad-1").read_bytes() == b"\xff\xfe not settings"


def test_settings_that_cannot_be_saved_are_a_warning(tmp_path: Path) -> None:
    (tmp_path / "folder").write_text("a file stands where the folder should be")
    warning = save(Settings(), tmp_path / "folder" / "settings.json")
    assert warning is not None
    assert "cannot be saved" in warning


def test_the_file_is_json_that_people_can_edit(tmp_path: Path) -> None:
    path = tmp_path / "settings.json"
    save(replace(Settings(), invert_pitch=True), path)
    assert json.loads(path.read_text())["invert_pitch"] is True
    assert path.read_text().count("\n") > 4
