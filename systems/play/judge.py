"""Judge: what a photograph holds and whether the objective is met.

A photograph is judged in the viewfinder's fixed 3:2 frame from the submarine's eye, never in the
window's, so a replay tells the same story in every window (DESIGN 7). A fish counts when its origin
is inside the frame, close enough, and neither rock nor ground stands between.
"""

from collections.abc import Sequence

from components.arrays import Float64s, Int32s
from components.camera import VIEWFINDER_ASPECT, VIEWFINDER_SLOPE, Camera, camera_at
from components.clock import TICKS_PER_SECOND, Clock
from components.command import CommandTable
from components.fish import Population
from components.kernels import Launch, row
from components.objective import ObjectiveTable, Photograph
from components.possession import AvatarTable
from components.submarine import SubmarineTable
from components.terrain import Terrain, sees

_JUDGE_EVERY = TICKS_PER_SECOND // 10
_POINTS = 1000
_POINTS_EACH_MORE = 50
_POINTS_EACH_SHOT = 25
_POINTS_EACH_SECOND = 5


@row
def inside_frame(
    position: Float64s, fish: int, eye: Float64s, axes: Float64s, within: float
) -> bool:
    """Say whether row `fish` of `position` [m] stands in the viewfinder, at most `within` [m] away.

    `axes` (3, 3) holds the camera's forward, right and up as rows.
    """
    x = position[fish, 0] - eye[0]
    y = position[fish, 1] - eye[1]
    z = position[fish, 2] - eye[2]
    if x * x + y * y + z * z > within * within:
        return False
    ahead = axes[0, 0] * x + axes[0, 1] * y + axes[0, 2] * z
    right = axes[1, 0] * x + axes[1, 1] * y + axes[1, 2] * z
    up = axes[2, 0] * x + axes[2, 1] * y + axes[2, 2] * z
    half = VIEWFINDER_SLOPE * ahead
    inside: bool = ahead > 0.0 and abs(up) <= half and abs(right) <= half * VIEWFINDER_ASPECT
    return inside


@row
def count_framed(
    position: Float64s,
    species: Int32s,
    count: int,
    wanted: int,
    eye: Float64s,
    axes: Float64s,
    within: float,
    terrain: Terrain,
) -> int:
    """Count the fishes of species row `wanted` that a photograph from `eye` [m] would hold."""
    framed = 0
    for fish in range(count):
        if species[fish] != wanted or not inside_frame(position, fish, eye, axes, within):
            continue
        if sees(terrain, eye, position[fish]):
            framed += 1
    return framed


def score(framed: int, wanted: int, seconds: float, par_seconds: float, shots: int) -> int:
    """Return the points of a success: more fishes and a quicker dive earn, wasted photographs cost."""
    early = max(0, int(par_seconds - seconds)) * _POINTS_EACH_SECOND
    more = (framed - wanted) * _POINTS_EACH_MORE
    return max(_POINTS // 10, _POINTS + more + early - (shots - 1) * _POINTS_EACH_SHOT)


class Judge:
    """Reads population, submarine, commands, who the player is, terrain and clock; writes the objectives.

    A fish takes no photographs.
    """

    def __init__(
        self,
        objectives: ObjectiveTable,
        goals: Sequence[Photograph],
        par_seconds: float,
        population: Population,
        submarine: SubmarineTable,
        commands: CommandTable,
        avatar: AvatarTable,
        terrain: Terrain,
        clock: Clock,
    ) -> None:
        self.objectives = objectives
        self.goals = tuple(goals)
        self.par_seconds = par_seconds
        self.population = population
        self.submarine = submarine
        self.commands = commands
        self.avatar = avatar
        self.terrain = terrain
        self.clock = clock
        self._count_framed = Launch(count_framed)

    def __call__(self) -> None:
        """Judge a photograph taken this tick; ten times a second say what one would hold."""
        shutter = self.commands.pressed("photograph") and not self.avatar.attached
        if not shutter and self.clock.now % _JUDGE_EVERY:
            return
        camera = viewfinder(self.submarine)
        for index, goal in enumerate(self.goals):
            framed = 0 if self.avatar.attached else self._count(goal, camera)
            self.objectives.framed[index] = framed
            if shutter:
                self._photograph(index, goal, framed)

    def _count(self, goal: Photograph, camera: Camera) -> int:
        fish = self.population.fish
        return self._count_framed(
            fish.position,
            fish.species,
            fish.count,
            goal.species,
            camera.eye,
            camera.axes,
            goal.within,
            self.terrain,
        )

    def _photograph(self, index: int, goal: Photograph, framed: int) -> None:
        objectives = self.objectives
        objectives.latest[index] = framed
        objectives.shots[index] += 1
        objectives.best[index] = max(int(objectives.best[index]), framed)
        if framed < goal.count or objectives.done[index]:
            return
        objectives.done[index] = 1
        objectives.won_at[index] = self.clock.now
        seconds = self.clock.now / TICKS_PER_SECOND
        shots = int(objectives.shots[index])
        objectives.score[index] = score(framed, goal.count, seconds, self.par_seconds, shots)


def viewfinder(submarine: SubmarineTable, alpha: float = 1.0) -> Camera:
    """Return the submarine's camera with the viewfinder's lens, `alpha` of the way from the last tick to this."""
    eye = submarine.last_position[0] + alpha * (submarine.position[0] - submarine.last_position[0])
    yaw = submarine.last_yaw[0] + alpha * (submarine.yaw[0] - submarine.last_yaw[0])
    pitch = submarine.last_pitch[0] + alpha * (submarine.pitch[0] - submarine.last_pitch[0])
    return camera_at(eye, float(yaw), float(pitch), VIEWFINDER_SLOPE)
