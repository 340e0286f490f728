// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.OpenInterfaceBody;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.grammar.Parameter;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.RobotBodies;
import org.SEAR.raycast.Hit;
import org.SEAR.robot.wheel.SpringDesign;

/** Warnings about a robot before it drives. Simulation thread. */
public final class StartChecks {
    /** Largest relative difference from the dimensions that drivers assume. */
    private static final double ALIKE = 0.02;

    /** Distance from the middle below which a wheel is in the middle, metres. */
    private static final double MIDDLE = 1e-3;
    /** Acceleration below which motors are probably a mistake, m/s^2. */
    private static final double WEAK = 0.02;
    /** Speed at which a small robot visibly moves, m/s. */
    private static final double SLOW = 0.1;
    /** Tilt above which SEAR warns, degrees: more than the springs' deflection. */
    private static final double LEVEL = 2;
    /** Factor from the stiffness that just holds to the recommended one. */
    private static final double STIFF = 10;

    private StartChecks() {
    }

    /**
     * Warns of everything that keeps a robot from driving.
     * @param scenes with all objects at their start
     * @param warnings takes the warnings
     */
    public static void check(RobotModel robot, RaycastScenes scenes, List<String> warnings) {
        String name = robot.getObject().getName();
        if (robot.getObject().getMachine() != null) {
            return;     // a part that joints move
        }
        boolean moves = robot.getObject().getComponents().stream()
            .anyMatch(part -> part instanceof Servo || part instanceof Joint);
        if (robot.getObject().getWheels().isEmpty() && !moves) {
            warnings.add("robot " + name + " has no wheels and can't drive: robot.addWheel(Wheel(...)) adds one");
        }
        checkDimensions(robot, warnings);
        checkSides(robot.getObject(), warnings);
        checkPlaces(robot.getObject(), warnings);
        checkMotors(robot, warnings);
        if (!robot.hasFarWheels()) {
            checkStand(robot, warnings);
        }
        Pose pose = robot.getPose();
        double down = scenes.ground.cast(pose.x, pose.y, pose.z, 0, -1, 0, Double.MAX_VALUE,
            robot.getOwner(), new Hit());
        if (down == Double.POSITIVE_INFINITY && robot.truth().gravity() > 0) {
            warnings.add(String.format(Locale.ROOT, "robot %s has no ground below its start at x %.2f, y %.2f, z %.2f "
                + "and will fall:"
                + " Floor(\"floor\", 20, 20) makes one at height 0", name, pose.x, pose.y, pose.z));
        }
    }

    private static void checkStand(RobotModel robot, List<String> warnings) {
        checkLevel(robot, warnings);
        if (robot.getStability().isCritical()) {
            warnings.add("robot " + robot.getObject().getName() + " " + robot.getStability().getWords());
        }
        checkSprings(robot, false, "forwards or backwards", warnings);
        checkSprings(robot, true, "sideways", warnings);
    }

    /** A robot driven on one side only goes in circles. */
    private static void checkSides(SEARrobot robot, List<String> warnings) {
        List<Wheel> driven = robot.getWheels().stream().filter(Wheel::isDriven).collect(Collectors.toList());
        boolean left = driven.stream().allMatch(wheel -> wheel.getX() > MIDDLE);
        boolean right = driven.stream().allMatch(wheel -> wheel.getX() < -MIDDLE);
        if (!driven.isEmpty() && (left || right)) {
            Wheel first = driven.get(0);
            warnings.add(String.format(Locale.ROOT, "robot %s has all its driven wheels on the %s (%s, x %s m), so it "
                + "can't drive straight or turn"
                + " properly. x > 0 is left, x < 0 is right; wheel.move(%s, %s, %s) puts one on the other side",
                robot.getName(), left ? "left" : "right", first.getName(), Parameter.format(first.getX()),
                Parameter.format(-first.getX()),
                Parameter.format(first.getY()), Parameter.format(first.getZ())));
        }
    }

    /** Wheels without a position are all at the robot's origin. */
    private static void checkPlaces(SEARrobot robot, List<String> warnings) {
        List<Wheel> wheels = robot.getWheels();
        for (int i = 0; i < wheels.size(); i++) {
            Wheel one = wheels.get(i);
            for (Wheel other : wheels.subList(0, i)) {
                if (Math.hypot(one.getX() - other.getX(), one.getZ() - other.getZ()) < MIDDLE) {
                    warnings.add(String.format(Locale.ROOT, "robot %s has its wheels %s and %s at the same place, x "
                        + "%s, z %s m, so it can't"
                        + " stand on them. Give each its place with Wheel(name, radius, width, type, x, y, z) or "
                        + "wheel.move(x, y, z):"
                        + " x > 0 is left, z > 0 is front", robot.getName(), other.getName(), one.getName(),
                        Parameter.format(one.getX()),
                        Parameter.format(one.getZ())));
                    return;
                }
            }
        }
    }

    /** Checks how it stands on level ground, by the wheels' contact points under load. */
    private static void checkLevel(RobotModel robot, List<String> warnings) {
        double[] slope = robot.getStability().slope();
        double ahead = Math.toDegrees(Math.atan(slope[1]));
        double aside = Math.toDegrees(Math.atan(slope[0]));
        if (Math.max(Math.abs(ahead), Math.abs(aside)) > LEVEL) {
            boolean lengthwise = Math.abs(ahead) >= Math.abs(aside);
            warnings.add(String.format(Locale.ROOT, "robot %s stands tilted by %.0f degrees, with its %s up, because "
                + "its wheels don't reach down"
                + " equally far: %s. y - radius should be the same for all", robot.getObject().getName(),
                Math.abs(lengthwise ? ahead : aside),
                lengthwise ? ahead > 0 ? "back" : "front" : aside > 0 ? "right" : "left", robot.getObject()
                .getWheels().stream()
                .map(wheel -> String.format(Locale.ROOT, "%s to y %.3f m", wheel.getName(),
                    wheel.getY() - wheel.getRadius() * wheel.getScaleY()))
                .collect(Collectors.joining(", "))));
        }
    }

    /** Finds motors too weak for visible motion. */
    private static void checkMotors(RobotModel robot, List<String> warnings) {
        SEARrobot object = robot.getObject();
        double force = 0;
        Motor weakest = null;
        Set<String> turned = new HashSet<>();
        for (SearObject part : object.getComponents()) {
            if (part instanceof Motor && !((Motor) part).getWheelNames().isEmpty()) {
                Motor motor = (Motor) part;
                turned.addAll(motor.getWheelNames());
                String first = motor.getWheelNames().get(0);
                double radius = object.getWheels().stream().filter(wheel -> wheel.getName().equals(first))
                    .mapToDouble(Wheel::getRadius).findFirst()
                    .orElse(Double.POSITIVE_INFINITY);
                force += motor.getStallTorque() * motor.getGearRatio() / radius;
                weakest = weakest == null || motor.getStallTorque() < weakest.getStallTorque() ? motor : weakest;
            }
        }
        double mass = RobotBodies.whole(robot.getBody()).mass;
        boolean byMotorsOnly = object.getWheels().stream()
            .allMatch(wheel -> !wheel.isDriven() || turned.contains(wheel.getName()));
        if (weakest != null && byMotorsOnly && force < WEAK * mass) {
            warnings.add(String.format(Locale.ROOT, "robot %s weighs %s kg, but its motors push it with only %.2g N in "
                + "all: it needs %.0f s to"
                + " reach 0.1 m/s. Raise the stallTorque of %s, now %s N m, or its gearRatio", object.getName(),
                Parameter.format(mass), force,
                Math.ceil(SLOW * mass / force), weakest.getName(), Parameter.format(weakest.getStallTorque())));
        }
    }

    private static void checkSprings(RobotModel robot, boolean sideways, String way, List<String> warnings) {
        double[] centre = RobotBodies.whole(robot.getBody()).getCentre();
        double weight = RobotBodies.whole(robot.getBody()).mass * robot.truth().gravity();
        double times = SpringDesign.tooSoft(robot.getSprings(), robot.getObject().getWheels(), centre, weight,
            sideways);
        Double stiffness = robot.getDynamics().getStiffness();
        if (stiffness != null && times > 1) {
            warnings.add(String.format(Locale.ROOT, "robot %s falls over %s at rest: its springs of stiffness %s are "
                + "too soft for its centre of"
                + " mass at x %.3f, y %.3f, z %.3f of its frame. Set a stiffness of %.0f, or use Dynamics(name, mass), "
                + "which chooses one",
                robot.getObject().getName(), way, Parameter.format(stiffness), centre[0] + 0.0, centre[1] + 0.0,
                centre[2] + 0.0,
                Math.ceil(STIFF * times * stiffness)));
        }
    }

    private static void checkDimensions(RobotModel robot, List<String> warnings) {
        for (SearObject part : robot.getObject().getComponents()) {
            if (part instanceof Dynamics && ((Dynamics) part).getUserPort() != null) {
                checkDimensions(robot, OpenInterfaceBody.of(((Dynamics) part).getModel()), warnings);
            }
        }
    }

    /** A driver computes distances and turns from the dimensions of the real robot. */
    private static void checkDimensions(RobotModel robot, OpenInterfaceBody real, List<String> warnings) {
        SEARrobot object = robot.getObject();
        double base = robot.getHardware().getTrack();
        if (base > 0 && differ(base, real.track)) {
            warnings.add(String.format(Locale.ROOT, "robot %s answers as a %s, whose wheels are %.3f m apart, but its "
                + "own are %.3f m"
                + " apart: drivers misjudge its turns. Robots.%s(name) makes a robot that fits",
                object.getName(), real.model,
                real.track, base, real.model));
        }
        object.getWheels().stream().filter(wheel -> real.hasEncoders() && wheel.isDriven()
            && differ(wheel.getRadius(), real.wheelRadius))
            .findFirst().ifPresent(wheel ->
                warnings.add(String.format(Locale.ROOT, "robot %s answers as a %s, whose wheels have a "
                    + "radius of %.3f m,"
                + " but its wheel %s has %.3f m: drivers misjudge its distances. Robots.%s(name) makes a "
                + "robot that fits",
                object.getName(), real.model, real.wheelRadius, wheel.getName(), wheel.getRadius(), real.model)));
    }

    private static boolean differ(double one, double other) {
        return Math.abs(one - other) > ALIKE * other;
    }
}
