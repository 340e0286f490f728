// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * Bodies of one robot: that of its frame, and links that joints connect with it. They pass through each other, and
 * through the other robots of their machine.
 * Simulation thread.
 */
public final class RobotBodies {
    private final Body base;
    private final List<Body> links = new ArrayList<>();
    /** Normal impulses of the contacts of each solid in the present step, N s: of the base, then of each link. */
    private final List<double[]> pressed = new ArrayList<>();
    private Body whole;
    private String machine;

    /** @param base body of the robot's frame */
    public RobotBodies(Body base) {
        this.base = base;
        whole = base;
        pressed.add(new double[base.solids.size()]);
        base.setRobot(this);
    }

    /** @param name of the machine whose robots pass through each other; null for none */
    public void setMachine(String name) {
        machine = name;
    }

    /** Whether both are the same robot, or parts of one machine. */
    boolean isOneWith(RobotBodies other) {
        return this == other || machine != null && other != null && machine.equals(other.machine);
    }

    /** Adds a link. */
    public void addLink(Body link) {
        links.add(link);
        pressed.add(new double[link.solids.size()]);
        link.setRobot(this);
    }

    /** @param newWhole the robot with all its links in one body, at their start; it takes part in no world */
    public void setWhole(Body newWhole) {
        whole = newWhole;
        whole.setRobot(this);
    }

    /** Returns the body of the robot's frame; a body of no robot itself. */
    public static Body base(Body of) {
        return of.getRobot() == null ? of : of.getRobot().base;
    }

    /** Returns the robot with all its links in one body, at their start; a body of no robot itself. */
    public static Body whole(Body of) {
        return of.getRobot() == null ? of : of.getRobot().whole;
    }

    /** Whether a body is a link of a robot, not that of its frame. */
    public static boolean isLink(Body body) {
        return base(body) != body;
    }

    /** Whether something is true of one of a robot's bodies, which lie apart after a joint has broken. */
    public static boolean isAny(Body of, Predicate<Body> condition) {
        List<Body> links = of.getRobot().links;
        boolean found = condition.test(of);
        for (int i = 0; i < links.size() && !found; i++) {
            found = condition.test(links.get(i));
        }
        return found;
    }

    /** Adds the normal impulse of a contact, N s; does nothing for a body of no robot. */
    static void press(Body of, int solid, double impulse) {
        if (of.getRobot() != null) {
            of.getRobot().pressed(of)[solid] += impulse;
        }
    }

    /** Forgets the impulses on a body's solids. */
    public static void release(Body of) {
        if (of.getRobot() != null) {
            Arrays.fill(of.getRobot().pressed(of), 0);
        }
    }

    /** Returns the sum of the normal impulses on a robot's solid in the last step in which its body was awake, N s. */
    public static double getPressed(Body of, int solid) {
        return of.getRobot().pressed(of)[solid];
    }

    private double[] pressed(Body of) {
        return pressed.get(of == base ? 0 : 1 + links.indexOf(of));
    }

    /** Returns the bodies with each robot in one body. */
    public static List<Body> wholes(List<Body> bodies) {
        return bodies.stream().filter(body -> !isLink(body)).map(RobotBodies::whole).collect(Collectors.toList());
    }

    /** The whole robot was set to a start pose: so is the body of its frame. */
    void start(Body placed) {
        if (placed == whole && whole != base) {
            base.setStart(placed.getStart());
        }
    }

    /** Moves the links along with the body of the robot's frame, whose velocities change to {@code v}. */
    void follow(double... v) {
        double[] was = new double[v.length];
        double[] now = new double[v.length];
        base.velocities(was);
        for (Body link : links) {
            double[] change = new double[v.length];
            for (int i = 0; i < v.length; i++) {
                change[i] = v[i] - was[i];
            }
            double rx = link.getSolver().place.x - base.getSolver().place.x;
            double ry = link.getSolver().place.y - base.getSolver().place.y;
            double rz = link.getSolver().place.z - base.getSolver().place.z;
            change[0] += change[4] * rz - change[5] * ry;
            change[1] += change[5] * rx - change[3] * rz;
            change[2] += change[3] * ry - change[4] * rx;
            link.velocities(now);
            link.setVelocities(now[0] + change[0], now[1] + change[1], now[2] + change[2], now[3] + change[3],
                now[4] + change[4], now[5] + change[5]);
        }
    }

    /** Whether a body is that of the robot's frame, and has links. */
    boolean leads(Body body) {
        return body == base && !links.isEmpty();
    }
}
