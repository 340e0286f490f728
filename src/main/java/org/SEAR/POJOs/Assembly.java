package org.SEAR.POJOs;

import java.io.IOException;
import org.SEAR.grammar.Faults;

/** Puts objects that were read from files together; for the project room. */
public final class Assembly {
    private Assembly() {
    }

    /**
     * Makes a component that was read from its own file a part of the robot whose file names it.
     *
     * @param aside whether the file lies in the robot's own folder
     */
    public static void link(SEARrobot robot, SearObject component, boolean aside) {
        robot.link(component, aside);
    }

    /** The robot that a part belongs to; null for what is no robot's part. */
    public static SEARrobot robotOf(SearObject part) {
        return part.robot();
    }

    /**
     * Moves the file of a robot's component into the robot's own folder, see {@link SearObject#getFileName}, and writes the robot's file.
     *
     * @throws IOException if one of them can't be written; all is as before then
     * @throws IllegalArgumentException if the names are too long for that
     */
    public static void moveAside(SearObject component) throws IOException {
        component.robot().moveAside(component);
    }

    /**
     * Has a robot that was read name one of its components as a file in the robot's own folder.
     *
     * @return how it is named now, {@code robot/name}
     * @throws IllegalArgumentException if the names are too long for that
     */
    public static String nameAside(SEARrobot robot, String component) {
        return robot.nameAside(component);
    }

    /** Takes {@link #moveAside} back, but for the files. */
    public static void forgetAside(SearObject component) {
        component.robot().forgetAside(component);
    }

    /** Says what scripts call a part that was read, see {@link SearObject#getFullName}. */
    public static void setFullName(SearObject part, String fullName) {
        part.setFullName(fullName);
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
