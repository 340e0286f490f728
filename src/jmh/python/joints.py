# SPDX-License-Identifier: Apache-2.0
"""Mechanisms in SEAR and MuJoCo: error against MuJoCo at a step of 0.1 ms, and processor time."""
import json
import math
import os
import subprocess

MECHANISMS = ["chain-5", "chain-20", "hoist-20", "arm-7", "quadruped-12"]


def error(exact, track):
    """Returns the root of the mean squared distance of two paths, metres."""
    squares = [math.dist(a, b) ** 2 for a, b in zip(exact, track)]
    return math.sqrt(sum(squares) / len(squares))


def measure(run, mechanisms):
    """Returns a result for each mechanism, and why MuJoCo is missing."""
    reason = run.install("mujoco")
    results = []
    for name in mechanisms:
        run.say("SEAR%s: %s" % ("" if reason else ", MuJoCo", name))
        world, own, other = run.path(name + ".json"), run.path("joints.json"), run.path("joints-mujoco.json")
        run.call_java("Joints", name, world, own)
        result = {"name": name, "cpu": read(own)["cpu"]}
        if not reason:
            python = os.path.join(run.root, "build", "peers-mujoco", "bin", "python")
            here = os.path.dirname(os.path.abspath(__file__))
            subprocess.run([python, os.path.join(here, "mujoco_joints.py"), world, other], check=True, cwd=run.folder,
                           env=dict(os.environ, MUJOCO_GL="disable"))
            result.update(compare(read(own), read(other)))
        results.append(result)
    return results, {"mujoco": reason} if reason else {}


def compare(own, other):
    """Returns SEAR's error, and MuJoCo's cheapest run whose error is not larger."""
    exact = other["exact"]["track"]
    mine = error(exact, own["track"])
    runs = [dict(one, error=error(exact, one["track"])) for one in other["runs"]]
    good = [one for one in runs if one["error"] <= mine]
    best = min(good or runs, key=(lambda one: one["cpu"]) if good else (lambda one: one["error"]))
    return {"error": mine, "peer": {key: best[key] for key in ("cpu", "error", "step", "integrator")}}


def table(results):
    """Returns the lines of a Markdown table."""
    lines = ["| mechanism | SEAR: error, mm | CPU ms per s | MuJoCo: step, ms | error, mm | CPU ms per s | MuJoCo / SEAR |",
             "|---|---|---|---|---|---|---|"]
    for one in results:
        peer = one.get("peer")
        lines.append("| %s | %s | %.2f | %s |" % (
            one["name"], "%.2f" % (1000 * one["error"]) if peer else "–", 1000 * one["cpu"],
            "%.2f, %s | %.2f | %.2f | %.2f" % (1000 * peer["step"], peer["integrator"], 1000 * peer["error"],
                                               1000 * peer["cpu"], peer["cpu"] / one["cpu"]) if peer else "– | – | – | –"))
    return lines


def read(path):
    with open(path) as file:
        return json.load(file)
