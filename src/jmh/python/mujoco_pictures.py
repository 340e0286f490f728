# SPDX-License-Identifier: Apache-2.0
"""Camera pictures in MuJoCo, with mujoco.Renderer. "fast" omits antialiasing and uses a shadow map of 1024 pixels
instead of 4096."""
import mujoco

from mujoco_engine import UPRIGHT, box_xml

COLOR = 'rgba="0.7 0.7 0.65 1" contype="0" conaffinity="0"'
PICTURED = 'material="p%d" contype="0" conaffinity="0"'
FAST = '<quality shadowsize="1024" offsamples="0"/>'


def numbers(values):
    return " ".join("%.9g" % value for value in values)


def pose_xml(pose):
    x, y, z, qx, qy, qz, qw = pose
    return 'pos="%s" quat="%s"' % (numbers((x, y, z)), numbers((qw, qx, qy, qz)))


def looking(pose):
    """Returns the pose of a MuJoCo camera, which looks along its -z and has x to its right: half a turn about y."""
    x, y, z, qx, qy, qz, qw = pose
    return pose_xml((x, y, z, -qz, qw, qx, -qy))


class Scene:
    """The world, and a camera for each pose."""

    def __init__(self, world, fast):
        assets = []
        geoms = []
        pictures = {}
        for i, thing in enumerate(world["things"]):
            look = COLOR
            if "picture" in thing:
                look = PICTURED % pictures.setdefault((thing["picture"], thing["tile"]), len(pictures))
            if thing["kind"] == "box":
                geoms.append(box_xml(thing["half"] + thing["pose"], look))
            elif thing["kind"] == "cylinder":
                geoms.append('<body %s><geom type="cylinder" size="%s" quat="%s" %s/></body>'
                             % (pose_xml(thing["pose"]), numbers(thing["half"][:2]), UPRIGHT, look))
            else:
                assets.append('<mesh name="m%d" inertia="shell" vertex="%s" face="%s"/>'
                              % (i, numbers(thing["vertices"]), " ".join(str(index) for index in thing["indices"])))
                geoms.append('<geom type="mesh" mesh="m%d" %s %s/>' % (i, pose_xml(thing["pose"]), COLOR))
        for (file, tile), number in pictures.items():
            repeat = 'texuniform="true" texrepeat="%r %r"' % (1 / tile, 1 / tile) if tile else ""
            assets.append('<texture name="t%d" type="2d" file="%s"/><material name="p%d" texture="t%d" specular="0" %s/>'
                          % (number, file, number, number, repeat))
        cameras = ['<camera name="c%d" %s fovy="%.9g"/>' % (i, looking(pose), world["fovy"]) for i, pose in enumerate(world["poses"])]
        light = '<light directional="true" castshadow="true" pos="0 20 0" dir="%s" diffuse="0.8 0.8 0.8"/>' % numbers(-s for s in world["sun"])
        self.model = mujoco.MjModel.from_xml_string(
            '<mujoco><statistic extent="10" center="0 0 0"/><visual><map znear="0.002" zfar="10"/><headlight diffuse="0 0 0" specular="0 0 0"'
            ' ambient="0.4 0.4 0.4"/>%s</visual><asset>%s</asset><worldbody>%s</worldbody></mujoco>'
            % (FAST if fast else "", "".join(assets), light + "".join(geoms) + "".join(cameras)))
        self.data = mujoco.MjData(self.model)
        mujoco.mj_forward(self.model, self.data)
        self.renderer = mujoco.Renderer(self.model, world["height"], world["width"])

    def render(self, turn):
        self.renderer.update_scene(self.data, "c%d" % turn)
        return self.renderer.render()

    def colors(self, turn):
        self.renderer.disable_depth_rendering()
        return self.render(turn)

    def depth_buffer(self, turn):
        self.renderer.enable_depth_rendering()
        return self.render(turn)

    def depths(self, turn):
        """Returns the depths along the axis, metres."""
        return self.depth_buffer(turn)
