package org.SEAR.project.edit;

import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;

/** An object of a project, the file that it stands in, and the robot that it is a part of. Whoever holds the project's lock. */
final class ObjectLocation {
    /** The object; nobody else has it. */
    final SearObject object;
    /** The file's path below the project's folder. */
    final String path;
    /** The robot that it is a part of, from its own file; null if none. */
    final SEARrobot robot;

    ObjectLocation(SearObject object, String path, SEARrobot robot) {
        this.object = object;
        this.path = path;
        this.robot = robot;
    }

    /** What the file holds: the object itself, or the robot in whose file a wheel stands. */
    SearObject root() {
        return isWheel() ? robot : object;
    }

    boolean isWheel() {
        return object instanceof Wheel && robot != null;
    }

    /** The path of the robot's file. */
    String robotPath() {
        return ObjectFiles.path(true, robot.getName());
    }

    /** What edits call it: its name, with its robot's before it if it is a part. */
    String address() {
        return robot == null ? object.getName() : robot.getName() + "/" + object.getName();
    }
}
