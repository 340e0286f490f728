package org.SEAR.POJOs;

/** Puts objects that were read from files together; for the project room. */
public final class Assembly {
    private Assembly() {
    }

    /** Makes a component that was read from its own file a part of the robot whose file names it. */
    public static void link(SEARrobot robot, SearObject component) {
        robot.link(component);
    }

    /** Gives a distance sensor that was read from a file the shape of its named beam. */
    public static void link(Distance sensor, Beam beam) {
        sensor.link(beam);
    }

    /** Adds what is wrong with the values of an object together. */
    public static void crossCheck(SearObject object, Faults faults) {
        object.crossCheck(faults);
    }

    /** Whether an object can only be a part of a robot, so that its file lies in {@code robot/} from the start. */
    public static boolean isRobotPart(SearObject object) {
        return object.isRobotPart();
    }
}
