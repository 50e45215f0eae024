"""Clips that are wrong: one clear line with the frame, partial results kept and marked (issue 6, bad input)."""

from collections.abc import Callable
from pathlib import Path

import av
import cv2
import numpy as np
import pytest

from tools.video.faults import Fault
from tools.video.follow import Choices, Followed, follow
from tools.video.images import ClipError, Grey
from tools.video.reading import REDUCED_SIDE, Clip
from tools.video.writing import PLAYABLE, even, write_film


def _refused(path: Path, choices: Choices | None = None) -> str:
    with pytest.raises(ClipError) as error:
        follow(path, choices)
    told = str(error.value)
    assert told.startswith(f"{path}: ")
    assert "\n" not in told
    return told


def _faults(followed: Followed) -> set[Fault]:
    return {Fault(code) for code in followed.assembled.fault.tolist()} - {Fault.NONE}


@pytest.mark.parametrize("content", [b"", b"hello", bytes(range(256)) * 20])
def test_what_is_no_clip_is_refused(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "clip.mp4"
    path.write_bytes(content)
    assert "this is no clip" in _refused(path)


def test_a_missing_file_and_a_folder_are_refused(tmp_path: Path) -> None:
    assert "there is no such file" in _refused(tmp_path / "none.avi")
    assert "folder" in _refused(tmp_path)


def test_a_still_picture_is_refused(tmp_path: Path, frames: list[Grey]) -> None:
    for name in ("still.png", "still.jpg"):
        cv2.imwrite(str(tmp_path / name), frames[0])
        assert "still picture" in _refused(tmp_path / name)


def test_a_film_of_one_picture_is_refused(film: Callable[..., Path], frames: list[Grey]) -> None:
    assert "nothing moves in it" in _refused(film(frames[:1]))
    assert "nothing moves in it" in _refused(film([frames[0]] * 12))


def test_a_film_of_an_empty_tank_has_no_fish(film: Callable[..., Path]) -> None:
    chance = np.random.default_rng(0)
    tank = [chance.normal(180, 4, (240, 320)).astype(np.uint8) for _ in range(20)]
    assert "frame 0: no fish is seen" in _refused(film(tank))


def test_a_file_of_sound_alone_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "sound.mka"
    with av.open(str(path), "w", format="matroska") as container:
        stream = container.add_stream("pcm_s16le", rate=8000)
        sound = av.AudioFrame.from_ndarray(np.zeros((1, 1024), np.int16), "s16", "mono")
        sound.sample_rate = 8000
        container.mux(stream.encode(sound))
    assert "there are no pictures" in _refused(path)


def test_an_unknown_codec_is_told(tmp_path: Path, frames: list[Grey]) -> None:
    path = tmp_path / "clip.avi"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("mjpeg", rate=30)
        stream.width, stream.height, stream.pix_fmt = 320, 240, "yuvj420p"
        for frame in frames[:4]:
            container.mux(stream.encode(av.VideoFrame.from_ndarray(frame, format="gray")))
        container.mux(stream.encode(None))
    path.write_bytes(path.read_bytes().replace(b"MJPG", b"ZZQX"))
    assert "its codec is not known" in _refused(path)


def test_a_film_without_frames_is_told(tmp_path: Path, frames: list[Grey]) -> None:
    path = tmp_path / "clip.avi"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("mjpeg", rate=30)
        stream.width, stream.height, stream.pix_fmt = 320, 240, "yuvj420p"
        container.mux(stream.encode(av.VideoFrame.from_ndarray(frames[0], format="gray")))
        container.mux(stream.encode(None))
    content = bytearray(path.read_bytes())
    at = content.index(b"\xff\xd8", content.index(b"movi"))
    content[at : content.index(b"idx1")] = bytes(content.index(b"idx1") - at)
    path.write_bytes(bytes(content))
    assert "0 frames can be read" in _refused(path)


def test_a_film_cut_short_gives_what_it_holds(
    film: Callable[..., Path], frames: list[Grey]
) -> None:
    path = film(frames)
    content = path.read_bytes()
    path.write_bytes(content[: len(content) * 2 // 3])
    followed = follow(path)
    assert 20 < followed.assembled.motion.count < 35
    assert any("the file ends, but its header says 45" in note for note in followed.notes)


def test_damaged_frames_are_marked_up_to_the_next_whole_one(
    tmp_path: Path, frames: list[Grey]
) -> None:
    path = tmp_path / "clip.avi"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("mjpeg", rate=30)
        stream.width, stream.height, stream.pix_fmt = 320, 240, "yuvj420p"
        for frame in frames:
            container.mux(stream.encode(av.VideoFrame.from_ndarray(frame, format="gray")))
        container.mux(stream.encode(None))
    content = bytearray(path.read_bytes())
    middle = content.index(b"\xff\xd8", len(content) // 2)
    content[middle : middle + 1500] = bytes(1500)
    path.write_bytes(bytes(content))
    followed = follow(path)
    assert _faults(followed) == {Fault.DAMAGED}
    assert any("the frame is damaged; bridged" in note for note in followed.notes)
    assert np.isfinite(followed.assembled.motion.axis).all()


def test_the_longer_shot_of_a_cut_film_is_taken(
    film: Callable[..., Path], frames: list[Grey]
) -> None:
    dark = [(frame // 3).astype(np.uint8) for frame in frames[:15]]
    followed = follow(film([*frames[:30], *dark]))
    assert followed.assembled.motion.count == 30
    assert (followed.assembled.fault[30:] == Fault.CUT).all()
    assert any("frame 30: the film is cut here" in note for note in followed.notes)


def test_a_fish_that_leaves_is_followed_as_far_as_it_is_whole(
    film: Callable[..., Path], frames: list[Grey]
) -> None:
    gone = []
    for k, frame in enumerate(frames):
        away = np.array([[1.0, 0.0, 20.0 - 6.0 * k], [0.0, 1.0, 0.0]])
        gone.append(cv2.warpAffine(frame, away, (320, 240), borderMode=cv2.BORDER_REPLICATE))
    followed = follow(film(gone))
    assert Fault.AT_EDGE in _faults(followed)
    assert followed.assembled.motion.count > 15
    assert followed.assembled.fault[-1] != 0


def test_two_fishes_that_touch_are_told_and_bridged(
    film: Callable[..., Path], frames: list[Grey]
) -> None:
    both = []
    for k, frame in enumerate(frames):
        away = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, max(-60.0, 60.0 - 4.0 * k)]])
        other = cv2.warpAffine(frame, away, (320, 240), borderValue=(255.0,))
        both.append(np.minimum(frame, other))
    followed = follow(film(both), Choices(select=(160.0, 120.0)))
    assert Fault.TOUCHED in _faults(followed)
    motion = followed.assembled.motion
    touched = followed.assembled.fault[motion.first : motion.first + motion.count] != 0
    assert (motion.confidence[touched] == 0.0).all()
    # It is the chosen fish all along: it holds station while the other one passes.
    assert np.ptp(motion.centre[:, 1]) < 20.0


def test_of_two_fishes_the_chosen_one_is_followed(
    film: Callable[..., Path], frames: list[Grey]
) -> None:
    both = []
    for frame in frames:
        up, down = (
            cv2.warpAffine(
                frame, np.array([[1.0, 0.0, 0.0], [0.0, 1.0, y]]), (320, 240), borderValue=(255.0,)
            )
            for y in (-60.0, 60.0)
        )
        both.append(np.minimum(up, down))
    path = film(both)
    above, below = (follow(path, Choices(select=(160.0, y))) for y in (60.0, 180.0))
    assert above.assembled.motion.centre[:, 1].max() < 120.0
    assert below.assembled.motion.centre[:, 1].min() > 120.0


def test_a_place_outside_the_picture_is_refused(fish_film: Path) -> None:
    assert "lies outside its 320x240" in _refused(fish_film, Choices(select=(400.0, 20.0)))


def test_a_hand_is_no_fish(film: Callable[..., Path]) -> None:
    chance = np.random.default_rng(0)
    hands = []
    for k in range(24):
        hand = np.full((240, 320), 190, np.uint8)
        cv2.rectangle(hand, (0, 80 + k), (150, 140 + k), (60,), -1)
        for finger in range(4):
            root, tip = 85 + k + finger * 17, 70 + k + finger * 25
            cv2.line(hand, (150, root), (220, tip), (60,), 12)
        hands.append(np.clip(hand + chance.normal(0, 3, hand.shape), 0, 255).astype(np.uint8))
    told = _refused(film(hands))
    assert "the fish leaves the frame; no motion can be made" in told


def test_a_hand_wholly_in_the_frame_is_no_fish(film: Callable[..., Path]) -> None:
    chance = np.random.default_rng(0)
    hands = []
    for k in range(24):
        hand = np.full((240, 320), 190, np.uint8)
        cv2.rectangle(hand, (70, 85 + k), (150, 145 + k), (60,), -1)
        for finger in range(4):
            bent = round(10 * np.sin(0.6 * k + finger))
            root, tip = 92 + k + finger * 15, 60 + k + finger * 36 + bent
            cv2.line(hand, (150, root), (230, tip), (60,), 10)
        hands.append(np.clip(hand + chance.normal(0, 3, hand.shape), 0, 255).astype(np.uint8))
    told = _refused(film(hands))
    assert "frame 0: the axis leaves the fish; what moves is no fish in 19 of 24 frames" in told


def test_a_portrait_clip_is_a_clip(film: Callable[..., Path], frames: list[Grey]) -> None:
    followed = follow(film([np.ascontiguousarray(np.rot90(frame)) for frame in frames]))
    assert not _faults(followed)
    assert followed.assembled.motion.size == (240, 320)


@pytest.mark.parametrize("quarters", [1, 2, -1])
def test_a_telephones_clip_is_read_upright(
    tmp_path: Path, frames: list[Grey], quarters: int
) -> None:
    path = tmp_path / "telephone.mp4"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("libx264", rate=30, options={"crf": "10"})
        held = [np.ascontiguousarray(np.rot90(frame, -quarters)) for frame in frames[:20]]
        stream.height, stream.width = held[0].shape
        stream.pix_fmt = "yuv420p"
        stream.set_display_rotation(90 * quarters)
        for picture in held:
            container.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="gray")))
        container.mux(stream.encode(None))
    clip = Clip(path)
    assert (clip.width, clip.height) == (320, 240)
    first = next(iter(clip.frames(colour=True)))
    assert first.grey is not None
    assert first.colour is not None
    for shown in (first.grey, first.colour.mean(axis=2)):
        assert np.abs(shown.astype(float) - frames[0]).mean() < 12.0
    followed = follow(path)
    assert not _faults(followed)
    assert followed.assembled.motion.size == (320, 240)


def test_sixteen_bits_are_as_good_as_eight(tmp_path: Path, frames: list[Grey]) -> None:
    path = tmp_path / "deep.mkv"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("ffv1", rate=30)
        stream.width, stream.height, stream.pix_fmt = 320, 240, "gray16le"
        for frame in frames:
            deep = frame.astype(np.uint16) * np.uint16(257)
            container.mux(stream.encode(av.VideoFrame.from_ndarray(deep, format="gray16le")))
        container.mux(stream.encode(None))
    assert not _faults(follow(path))
    read = next(iter(Clip(path).frames())).grey
    assert read is not None
    assert np.abs(read.astype(int) - frames[0]).max() <= 1


def test_a_large_clip_is_worked_on_smaller_and_measured_as_shown(
    tmp_path: Path, frames: list[Grey]
) -> None:
    path = tmp_path / "large.mp4"
    large = (np.asarray(cv2.resize(frame, (1920, 1440)), np.uint8) for frame in frames[:12])
    write_film(path, (even(frame) for frame in large), 30.0, PLAYABLE)
    clip = Clip(path)
    assert clip.working == (REDUCED_SIDE, 720)
    followed = follow(path)
    assert followed.assembled.motion.size == (1920, 1440)
    assert followed.assembled.motion.length == pytest.approx(6 * 144, rel=0.03)


def test_frames_of_4k_pass_at_the_working_size(tmp_path: Path, frames: list[Grey]) -> None:
    path = tmp_path / "ultra.mp4"
    ultra = (np.asarray(cv2.resize(frame[30:210], (3840, 2160)), np.uint8) for frame in frames[:5])
    write_film(path, ultra, 30.0, PLAYABLE)
    followed = follow(path)
    assert followed.assembled.motion.size == (3840, 2160)
    assert followed.scene.plate.shape == (540, REDUCED_SIDE)
    assert not _faults(followed)


def test_a_still_tail_gives_no_rate(film: Callable[..., Path], frames: list[Grey]) -> None:
    drifting = []
    for k in range(20):
        away = np.array([[1.0, 0.0, 3.0 * k - 30.0], [0.0, 1.0, 0.0]])
        drifting.append(
            cv2.warpAffine(frames[0], away, (320, 240), borderMode=cv2.BORDER_REPLICATE)
        )
    path = film(drifting)
    with pytest.raises(ClipError, match="the tail does not beat"):
        follow(path, Choices(beats=2.0))
