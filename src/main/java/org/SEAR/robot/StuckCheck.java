// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.grammar.Parameter;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.Body;
import org.SEAR.project.ObjectPose;

/**
 * Explains once per run why a robot does not move although its wheels have a command: an object blocks it, or its
 * driven wheels hang. Simulation thread.
 */
final class StuckCheck {
    /** Number of steps for which it stands before SEAR warns: 2 s. */
    private static final int PATIENCE = (int) Math.round(2 / TimeStep.SECONDS);
    /** Smallest command that counts, m/s. */
    private static final double MIN_COMMAND = 0.03;
    /** Largest share of the commanded speed at which a robot counts as stuck. */
    private static final double MAX_SHARE = 0.05;
    /** Smallest forward part of the direction of a sensor that looks ahead. */
    private static final double AHEAD = 0.5;
    private static final double HALF_ROUND = 180;

    private final SEARrobot robot;
    private Body blocker;
    private double side;
    private int standing;
    private boolean reported;

    StuckCheck(SEARrobot robot) {
        this.robot = robot;
    }

    void restart() {
        blocker = null;
        standing = 0;
        reported = false;
    }

    /**
     * Notes that a steep surface touches the robot.
     *
     * @param ahead place of the contact in the robot's frame, metres along its z
     */
    void touched(Body other, double ahead) {
        if (other != null && ahead * side > 0) {
            blocker = other;
        }
    }

    /**
     * Takes a step.
     *
     * @param commanded speed, m/s, + forward; likewise speed
     * @param grounded whether a driven wheel has ground
     * @return a warning; null for none
     */
    String step(double commanded, double speed, boolean grounded) {
        boolean stands = Math.abs(commanded) >= MIN_COMMAND && Math.abs(speed) < MAX_SHARE * Math.abs(commanded)
            && commanded * side >= 0 && (blocker != null || !grounded);
        standing = stands ? standing + 1 : 0;
        String warning = null;
        if (standing >= PATIENCE && !reported) {
            reported = true;
            warning = words(commanded);
        }
        side = Math.signum(commanded);
        blocker = null;
        return warning;
    }

    private String words(double commanded) {
        String start = String.format(Locale.ROOT, "robot %s can't obey the command to drive at %.2f m/s: ",
            robot.getName(), commanded);
        if (blocker == null) {
            return start + "its driven wheels hang and have no ground below them. Lower the wheels, or raise what the "
                + "robot rests on";
        }
        String name = blocker.name;
        String why = blocker.isFixed() ? ", which is fixed (mass 0), blocks it. If it should move, give it a mass: "
            + name + ".setMass(1)" : String.format(Locale.ROOT, ", which weighs %s kg, blocks it",
            Parameter.format(blocker.mass));
        return start + name + why + blind(commanded);
    }

    /** Returns that no distance sensor looks where the robot drives; empty if one does, or if they may move. */
    private String blind(double commanded) {
        List<SearObject> parts = robot.getComponents();
        List<SearObject> sensors = parts.stream().filter(part -> part instanceof Distance || part instanceof LIDAR)
            .collect(Collectors.toList());
        double way = Math.signum(commanded);
        boolean seen = sensors.stream().anyMatch(part -> part instanceof LIDAR
            && ((LIDAR) part).getSpread() >= HALF_ROUND || way * direction(part)[2] > AHEAD);
        boolean moves = parts.stream().anyMatch(part -> part instanceof Servo || part instanceof Joint);
        if (sensors.isEmpty() || seen || moves) {
            return "";
        }
        SearObject first = sensors.get(0);
        return ". Its sensor " + first.getName() + " looks " + word(direction(first)) + ", not where it drives: "
            + first.getName() + ".rotate(0, " + (way > 0 ? 0 : (int) HALF_ROUND) + ", 0) turns it";
    }

    private static double[] direction(SearObject sensor) {
        return ObjectPose.of(sensor).rotate(0, 0, 1);
    }

    private static String word(double[] way) {
        double x = Math.abs(way[0]);
        double y = Math.abs(way[1]);
        double z = Math.abs(way[2]);
        if (x >= y && x >= z) {
            return way[0] > 0 ? "to the left" : "to the right";
        }
        return y >= z ? way[1] > 0 ? "up" : "down" : way[2] > 0 ? "ahead" : "back";
    }
}
