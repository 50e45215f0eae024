"""Names for what the video tools pass on: pictures, and the one error they raise."""

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from components.fault import FaultError

Grey: TypeAlias = NDArray[np.uint8]
"""A picture of brightness, or a mask of 0 and 255, (height, width)."""
Colour: TypeAlias = NDArray[np.uint8]
"""A picture in red, green, blue, (height, width, 3)."""
Bools: TypeAlias = NDArray[np.bool_]


class ClipError(FaultError):
    """A clip cannot be used: one line that names the file, the frame where there is one, and what is wrong."""
