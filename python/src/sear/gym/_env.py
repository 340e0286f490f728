"""A project as an environment of Gymnasium."""
import gymnasium
import numpy
from gymnasium import spaces

from ._java import Episode
from ._robot import RobotState

SECONDS = 1 / 60
FASTEST = 10.0
SEEDS = 2 ** 62


def _wheels(pair, number):
    try:
        left, right = (float(one) for one in pair)
    except (TypeError, ValueError):
        raise ValueError("action %d is %r, legal: the speeds of the left and the right wheels, m/s, as (0.2, 0.2)" % (number, pair)) from None
    if not (abs(left) <= FASTEST and abs(right) <= FASTEST):
        raise ValueError("action %d is %r, legal: -%g to %g m/s" % (number, pair, FASTEST, FASTEST))
    return left, right


def _start(place):
    try:
        x, z, heading = (None,) * 3 if place is None else (float(one) for one in place)
    except (TypeError, ValueError):
        raise ValueError("start is %r, legal: x and z in metres and heading in degrees" % (place,)) from None
    return None if place is None else (x, z, heading)


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
        if isinstance(steps_per_action, bool) or not isinstance(steps_per_action, int) or steps_per_action < 1:
            raise ValueError("steps_per_action is %r, legal: a whole number from 1" % (steps_per_action,))
        if max_seconds is not None and not max_seconds > 0:
            raise ValueError("max_seconds is %r, legal: above 0, or None" % (max_seconds,))
        if start is not None and not callable(start) and not len(start):
            raise ValueError("start is an empty list, legal: None, a list of (x, z, heading), or a function that answers one")
        self._set_actions(actions)
        self._episode = Episode(project, robot, sensors, list(things), FASTEST, 0)
        self._reward = reward or forward
        self._done = done or crashed
        self._start = start
        self._steps = steps_per_action
        self._limit = max_seconds
        self._seed = seed
        self._size = size
        self._ready = False
        self.render_mode = render_mode
        self.metadata = dict(self.metadata, render_fps=max(1, round(60 / steps_per_action)))
        self.robot = RobotState(self._episode)
        self.observation_space = spaces.Box(self._episode.low, self._episode.high, dtype=numpy.float32)

    def _set_actions(self, actions):
        if isinstance(actions, (int, float)) and not isinstance(actions, bool):
            if not 0 < actions <= FASTEST:
                raise ValueError("actions is %r, legal: a list of (left, right), or the highest speed of the wheels, above 0 to %g m/s"
                                 % (actions, FASTEST))
            self._choices = None
            self.action_space = spaces.Box(-float(actions), float(actions), (2,), numpy.float32)
        else:
            self._choices = [_wheels(pair, number) for number, pair in enumerate(actions)]
            if not self._choices:
                raise ValueError("actions is an empty list, legal: one or more (left, right)")
            self.action_space = spaces.Discrete(len(self._choices))

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
            raise ValueError("options has %s, legal: start, noise" % ", ".join(sorted(unknown)))
        start = _start(options.get("start", self._place()))
        noise = int(options.get("noise", self.np_random.integers(SEEDS)))
        self._episode.reset(noise, start)
        self.robot._begin()
        self._ready = True
        return self._episode.numbers.copy(), {}

    def step(self, action):
        """Does an action. Raises ValueError for one that is not legal."""
        if not self._ready:
            raise RuntimeError("reset() has to come before step()")
        if self._choices is None:
            left, right = float(action[0]), float(action[1])
            most = float(self.action_space.high[0])
            if not (abs(left) <= most and abs(right) <= most):
                raise ValueError("action is %s, legal: two speeds from -%g to %g m/s" % (action, most, most))
        else:
            if not 0 <= action < len(self._choices):
                raise ValueError("action is %s, legal: 0 to %d" % (action, len(self._choices) - 1))
            left, right = self._choices[action]
        self._episode.step(left, right, self._steps)
        robot = self.robot
        robot._acted(action)
        reward = float(self._reward(robot))
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
