# SPDX-License-Identifier: Apache-2.0
"""A project as a Gymnasium environment."""
from numbers import Real

import gymnasium
import numpy
from gymnasium import spaces

from . import _legal
from ._java import Episode
from ._robot import RobotState

SECONDS = 1 / 60
FASTEST = 10.0
SEEDS = 2 ** 62
MOST_STEPS = 216000


class SearEnv(gymnasium.Env):
    """One learning robot of a project.

    project: a .sear file or a folder SEARproject.
    robot: its name; optional if there is only one.
    sensors: names of the observed sensors and joints. Default: all sensors except cameras, or the cameras if there are
        no others.
    things: names of objects whose poses are observed, too.
    actions: a list of wheel speeds (left, right), m/s, from which the learner chooses; or a number: the learner chooses
        both speeds, up to that number. For other controls a dictionary of their ranges, as {"speed": (0, 1),
        "steering": (-30, 30)}, or a list of dictionaries of values. A key is a motor (power, -1 to 1) or servo (degrees)
        of the robot, a joint with a motor (position between its limits, else speed), else "left" and "right" or "speed"
        (wheels, m/s), or "steering" (degrees, + left).
    reward: a function of the RobotState after an action. Default: distance moved forward, less 1 for a bump.
    done: a function that returns whether the episode has ended. Default: the robot has bumped, lies on its side or has
        fallen off the floor.
    start: None for the project's own pose; a list of (x, z, heading), from which each episode draws one; or a function
        of a numpy random generator that returns one.
    steps_per_action: number of steps of 1/60 s.
    max_seconds: simulated time after which an episode is truncated; None for no limit.
    seed: for episodes started without one, so that two runs of a program are the same; None: random.
    render_mode: "rgb_array" for pictures from above, or None.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 60}

    def __init__(self, project, robot=None, sensors=None, actions=1.0, reward=None, done=None, steps_per_action=6, max_seconds=60, things=(),
                 start=None, seed=None, render_mode=None, size=(480, 360)):
        if render_mode not in (None, "rgb_array"):
            raise ValueError("render_mode is %r, legal: \"rgb_array\" or None" % (render_mode,))
        self._steps = _legal.whole("steps_per_action", steps_per_action, 1, MOST_STEPS)
        self._limit = _legal.seconds("max_seconds", max_seconds)
        self._start = _legal.places(start)
        self._reward = _legal.function("reward", reward, forward)
        self._done = _legal.function("done", done, crashed)
        self._size = _legal.size(size)
        self._set_actions(actions)
        self._episode = Episode(project, robot, None if sensors is None else _legal.names("sensors", sensors), _legal.names("things", things), FASTEST,
                                0)
        if self._controls:
            self._episode.set_controls(self._controls, self._choices or self._limits)
        self._seed = seed
        self._ready = False
        self.render_mode = render_mode
        self.metadata = dict(self.metadata, render_fps=60 // self._steps if 60 % self._steps == 0 else 60 / self._steps)
        self.robot = RobotState(self._episode)
        self.observation_space = self._space()

    def _space(self):
        """Returns a vector for numbers, a picture for a single camera, else a dictionary by name."""
        episode = self._episode
        pictures = {name: spaces.Box(0, 255, picture.shape, numpy.uint8) for name, picture in episode.pictures.items()}
        if not pictures:
            return spaces.Box(episode.low, episode.high, dtype=numpy.float32)
        if len(pictures) == 1 and not episode.slices:
            return next(iter(pictures.values()))
        return spaces.Dict({**{name: spaces.Box(episode.low[part], episode.high[part], dtype=numpy.float32) for name, part in episode.slices.items()},
                            **pictures})

    def _observation(self):
        episode = self._episode
        if not episode.pictures:
            return episode.numbers.copy()
        pictures = {name: picture.copy() for name, picture in episode.pictures.items()}
        if not isinstance(self.observation_space, spaces.Dict):
            return next(iter(pictures.values()))
        return {**{name: episode.numbers[part].copy() for name, part in episode.slices.items()}, **pictures}

    def _set_actions(self, actions):
        self._controls, self._choices, self._limits = _legal.actions(actions, FASTEST)
        if self._choices:
            self.action_space = spaces.Discrete(len(self._choices))
        else:
            low, high = (numpy.array(limit, numpy.float32) for limit in self._limits)
            self.action_space = spaces.Box(low, high, dtype=numpy.float32)

    def _place(self):
        if self._start is None or callable(self._start):
            return self._start and self._start(self.np_random)
        return self._start[int(self.np_random.integers(len(self._start)))]

    def reset(self, *, seed=None, options=None):
        """Starts an episode. options: {"start": (x, z, heading)} sets the pose, {"noise": n} the seed of the sensors'
        errors."""
        if seed is None and self._seed is not None:
            seed, self._seed = self._seed, None
        super().reset(seed=seed)
        options = options or {}
        unknown = set(options) - {"start", "noise"}
        if unknown:
            raise ValueError("options has %s, legal: start, noise" % ", ".join(sorted(map(str, unknown))))
        start = _legal.place("start", options.get("start", self._place()))
        noise = _legal.whole("noise", options.get("noise", self.np_random.integers(SEEDS)), -2 ** 63, 2 ** 63 - 1)
        self._episode.reset(noise, start)
        self.robot._begin()
        self._ready = True
        return self._observation(), {}

    def step(self, action):
        """Performs an action. Raises ValueError for an illegal one."""
        if not self._ready:
            raise RuntimeError("call reset() before step()")
        if self._choices:
            values = self._choices[_legal.whole("action", action, 0, len(self._choices) - 1)]
        elif self._controls:
            values = _legal.values(action, self._controls, *self._limits)
        else:
            values = _legal.speeds(action, float(self.action_space.high[0]))
        if self._controls:
            self._episode.act(values, self._steps)
        else:
            self._episode.step(*values, self._steps)
        robot = self.robot
        robot._acted(action)
        reward = _legal.reward(self._reward(robot))
        ended = bool(self._done(robot))
        late = self._limit is not None and robot.time >= self._limit - SECONDS / 2
        return self._observation(), reward, ended, late, {}

    def render(self):
        """Returns a picture from above as an array of height, width and colour; None without a render_mode."""
        if self.render_mode is None:
            gymnasium.logger.warn("render() draws nothing: create the environment with render_mode=\"rgb_array\"")
            return None
        return self._episode.draw(*self._size)

    def close(self):
        """Releases the world."""
        self._episode.close()
        self._ready = False

    def parts(self, observation):
        """Splits an observation by the names of sensors and objects: views of the arrays."""
        if isinstance(observation, dict):
            return dict(observation)
        if self._episode.pictures:
            return {name: observation for name in self._episode.pictures}
        return {name: observation[part] for name, part in self._episode.slices.items()}


def forward(robot):
    """Returns a reward: distance moved forward in metres, less 1 for a bump."""
    return robot.moved - robot.bumped


def crashed(robot):
    """Whether the robot has bumped into an object, lies on its side, or has fallen off the floor."""
    return robot.bumped or robot.tilt > 60 or robot.y < -0.5
