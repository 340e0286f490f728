// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;

/** An object of a project, its file, and the robot that it belongs to. Guarded by the project lock. */
final class ObjectLocation {
    /** The object, which is not shared. */
    final SearObject object;
    /** Path of the file below the project's folder. */
    final String path;
    /** Robot of a part, from its own file; null for no part. */
    final SEARrobot robot;

    ObjectLocation(SearObject object, String path, SEARrobot robot) {
        this.object = object;
        this.path = path;
        this.robot = robot;
    }

    /** Returns the root object of the file: the object itself, or the robot of a wheel. */
    SearObject root() {
        return isWheel() ? robot : object;
    }

    boolean isWheel() {
        return object instanceof Wheel && robot != null;
    }

    /** Returns the path of the robot's file. */
    String robotPath() {
        return ObjectFiles.path(true, robot.getName());
    }

    /** Returns the address in edits: the name, for a part with its robot's name in front. */
    String address() {
        return robot == null ? object.getName() : robot.getName() + "/" + object.getName();
    }
}
