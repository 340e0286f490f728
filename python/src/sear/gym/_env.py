"""A project as an environment of Gymnasium."""
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
    """One robot of a project that learns.

    project: a .sear file or a folder SEARproject.
    robot: its name; not needed if there is one only.
    sensors: the names of those that are observed; all but cameras unless said.
    things: names of things whose places are observed, too.
    actions: a list of (left, right), the speeds of the wheels, m/s, of which the learner chooses one; or a number: it chooses both speeds, up to
        that.
    reward: a function of the RobotState after an action; how far it has moved forward, less 1 for a bump, unless said.
    done: a function that says whether the episode has come to its end; unless said, when the robot bumps, lies on its side or has fallen off the
        floor.
    start: None for the project's own place; a list of (x, z, heading), of which each episode takes one by chance; or a function of a numpy
        random generator that answers one.
    steps_per_action: of 1/60 s.
    max_seconds: of simulated time, after which an episode is cut off; None for no limit.
    seed: for an episode that is started without one, so that two runs of a program are the same; None: by chance.
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
        self._seed = seed
        self._ready = False
        self.render_mode = render_mode
        self.metadata = dict(self.metadata, render_fps=max(1, round(60 / self._steps)))
        self.robot = RobotState(self._episode)
        self.observation_space = spaces.Box(self._episode.low, self._episode.high, dtype=numpy.float32)

    def _set_actions(self, actions):
        if hasattr(actions, "__iter__"):
            self._choices = [_legal.wheels("action %d" % number, pair, FASTEST) for number, pair in enumerate(actions)]
            if not self._choices:
                raise ValueError("actions is an empty list, legal: one or more (left, right)")
            self.action_space = spaces.Discrete(len(self._choices))
        else:
            if isinstance(actions, bool) or not isinstance(actions, Real) or not 0 < actions <= FASTEST:
                raise ValueError("actions is %r, legal: a list of (left, right), or the highest speed of the wheels, above 0 to %g m/s"
                                 % (actions, FASTEST))
            self._choices = None
            self.action_space = spaces.Box(-float(actions), float(actions), (2,), numpy.float32)

    def _place(self):
        if self._start is None or callable(self._start):
            return self._start and self._start(self.np_random)
        return self._start[int(self.np_random.integers(len(self._start)))]

    def reset(self, *, seed=None, options=None):
        """Starts an episode. options: {"start": (x, z, heading)} chooses the place, {"noise": n} the seed of the sensors' errors."""
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
        return self._episode.numbers.copy(), {}

    def step(self, action):
        """Does an action. Raises ValueError for one that is not legal."""
        if not self._ready:
            raise RuntimeError("reset() has to come before step()")
        if self._choices is None:
            left, right = _legal.speeds(action, float(self.action_space.high[0]))
        else:
            left, right = self._choices[_legal.whole("action", action, 0, len(self._choices) - 1)]
        self._episode.step(left, right, self._steps)
        robot = self.robot
        robot._acted(action)
        reward = _legal.reward(self._reward(robot))
        ended = bool(self._done(robot))
        late = self._limit is not None and robot.time >= self._limit - SECONDS / 2
        return self._episode.numbers.copy(), reward, ended, late, {}

    def render(self):
        """A picture from above, if render_mode says so: an array of height, width, colour."""
        if self.render_mode is None:
            gymnasium.logger.warn("render() draws nothing: say render_mode=\"rgb_array\" when the environment is made")
            return None
        return self._episode.draw(*self._size)

    def close(self):
        """Lets go of the world."""
        self._episode.close()
        self._ready = False

    def parts(self, observation):
        """An observation by the names of sensors and things: views of the array."""
        return {name: observation[part] for name, part in self._episode.slices.items()}


def forward(robot):
    """A reward: how far it has moved forward, metres, less 1 for a bump."""
    return robot.moved - robot.bumped


def crashed(robot):
    """Whether it has bumped into something, lies on its side, or has fallen off the floor."""
    return robot.bumped or robot.tilt > 60 or robot.y < -0.5
