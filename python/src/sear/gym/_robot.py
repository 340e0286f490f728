# SPDX-License-Identifier: Apache-2.0
"""The argument of reward functions."""

(TIME, X, Y, Z, HEADING, TILT, SPEED, TURN_RATE, PATH, TURNED, LEFT, RIGHT, TOUCHED) = range(13)


def _number(at, text):
    def read(self):
        return float(self._state[at])
    return property(read, doc=text)


def _truth(at, text):
    def read(self):
        return self._state[at] > 0
    return property(read, doc=text)


class RobotState:
    """The robot after an action. robot["frontEye"] is a reading: a number, or a numpy array of a LIDAR's beams from right
    to left, of a GPS's metres north, up and east of the world's origin, or of a camera's rows, columns and red, green and
    blue. For an object it is a numpy array: metres ahead, metres to the left, and cosine and sine of the angle to its
    forward axis.

    The arrays change with the next action; copy values to keep them.
    """

    time = _number(TIME, "Seconds since the start of the episode.")
    x = _number(X, "Metres to the north.")
    y = _number(Y, "Metres upwards.")
    z = _number(Z, "Metres to the east.")
    heading = _number(HEADING, "Degrees clockwise from north, (-180, 180]: 90 is east.")
    tilt = _number(TILT, "Degrees from upright.")
    speed = _number(SPEED, "Metres per second, + forward.")
    turn_rate = _number(TURN_RATE, "Degrees per second, + to the left.")
    path = _number(PATH, "Metres driven forward since the start, less those driven backward.")
    turned = _number(TURNED, "Degrees turned since the start, + to the left.")
    bumped_left = _truth(LEFT, "Whether the left half of the bumper has touched an object during the action.")
    bumped_right = _truth(RIGHT, "Whether the right half of the bumper has touched an object during the action.")
    touched = _truth(TOUCHED, "Whether any part except the wheels has touched an object during the action.")

    def __init__(self, episode):
        self._state = episode.state
        self._numbers = episode.numbers
        self._slices = episode.slices
        self._pictures = episode.pictures
        self.memory = {}
        self.action = None
        self.moved = 0.0
        self._last = 0.0

    def __getitem__(self, name):
        if name in self._pictures:
            return self._pictures[name]
        try:
            part = self._slices[name]
        except KeyError:
            raise KeyError("%s is not observed, legal: %s" % (name, ", ".join(self))) from None
        if part.stop - part.start == 1:
            return float(self._numbers[part.start])
        return self._numbers[part]

    def __iter__(self):
        return iter([*self._slices, *self._pictures])

    @property
    def bumped(self):
        """Whether the bumper has touched an object during the action."""
        return self._state[LEFT] + self._state[RIGHT] > 0

    def _begin(self):
        self.memory = {}
        self.action = None
        self.moved = 0.0
        self._last = float(self._state[PATH])

    def _acted(self, action):
        path = float(self._state[PATH])
        self.action = action
        self.moved = path - self._last
        self._last = path

    def __repr__(self):
        return "<%.2f s: x %.3f, z %.3f, heading %.1f, %.2f m/s>" % (self.time, self.x, self.z, self.heading, self.speed)
