// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.solid.MassProperties;
import org.SEAR.physics.solid.Solid;
import org.SEAR.project.ObjectPose;

/**
 * Parts of a robot that one servo turns, as a body. Its frame is that of the robot while the servo is at 0 degrees, and
 * turns with the servo. Simulation thread.
 */
public final class RobotLink {
    /** Number that stands for no component. */
    static final int NONE = -1;
    /** Mass of the shapes on a servo if none of them has a mass, kg. */
    private static final double LIGHT = 0.001;
    /** Smallest mass of a link as a share of the links that it carries: lighter ones can't be solved. */
    private static final double MIN_SHARE = 0.001;

    /** Index of its servo among the components. */
    final int servo;
    /** Link that carries the servo; null for the robot's own body. */
    final RobotLink carrier;
    /** Its shapes. */
    final List<Solid> solids = new ArrayList<>();
    /** In the robot's frame with all servos at 0 degrees. */
    final MassProperties masses;
    private Body body;

    private RobotLink(SEARrobot robot, int servo, RobotLink carrier, Map<SearObject, Solid> shapes) {
        this.servo = servo;
        this.carrier = carrier;
        List<SearObject> parts = robot.getComponents();
        List<MassProperties> heavy = new ArrayList<>();
        List<MassProperties> light = new ArrayList<>();
        for (int i = 0; i < parts.size(); i++) {
            Solid solid = carrier(parts, i) == servo ? shapes.get(parts.get(i)) : null;
            if (solid != null) {
                solids.add(solid);
                MassProperties unit = solid.perKilogram().inParent(ObjectPose.of(parts.get(i)).times(solid.offset));
                double mass = ((Shape) parts.get(i)).getMass();
                (mass > 0 ? heavy : light).add(unit.withMass(mass > 0 ? mass : solid.volume()));
            }
        }
        List<MassProperties> carried = new ArrayList<>();
        weigh(robot, servo, shapes, carried);
        double least = carried.isEmpty() ? LIGHT : Math.max(LIGHT, MIN_SHARE * MassProperties.sum(carried).mass);
        MassProperties own = MassProperties.sum(!heavy.isEmpty() ? heavy : !light.isEmpty() ? light : carried);
        masses = own.withMass(heavy.isEmpty() ? least : Math.max(least, own.mass));
    }

    /** Returns the links of a robot, each after the one that carries it. */
    static List<RobotLink> of(SEARrobot robot, Map<SearObject, Solid> shapes) {
        List<RobotLink> all = new ArrayList<>();
        add(robot, NONE, null, shapes, all);
        return all;
    }

    private static void add(SEARrobot robot, int on, RobotLink carrier, Map<SearObject, Solid> shapes,
        List<RobotLink> all) {
        List<SearObject> parts = robot.getComponents();
        for (int i = 0; i < parts.size(); i++) {
            if (parts.get(i) instanceof Servo && carrier(parts, i) == on && turnsShapes(robot, i, shapes)) {
                RobotLink link = new RobotLink(robot, i, carrier, shapes);
                all.add(link);
                add(robot, i, link, shapes, all);
            }
        }
    }

    /** Returns the index of the servo that turns a component; {@link #NONE} if none does. */
    static int carrier(List<SearObject> parts, int part) {
        for (int i = 0; i < parts.size(); i++) {
            if (parts.get(i) instanceof Servo
                && ((Servo) parts.get(i)).getPartNames().contains(parts.get(part).getName())) {
                return i;
            }
        }
        return NONE;
    }

    /** Whether a servo, or one that it turns, turns a shape. */
    private static boolean turnsShapes(SEARrobot robot, int servo, Map<SearObject, Solid> shapes) {
        List<SearObject> parts = robot.getComponents();
        for (int i = 0; i < parts.size(); i++) {
            if (carrier(parts, i) == servo && (shapes.containsKey(parts.get(i))
                || parts.get(i) instanceof Servo && turnsShapes(robot, i, shapes))) {
                return true;
            }
        }
        return false;
    }

    /** Collects the masses of all shapes that a servo's servos turn, in the robot's frame. */
    private static void weigh(SEARrobot robot, int servo, Map<SearObject, Solid> shapes, List<MassProperties> into) {
        List<SearObject> parts = robot.getComponents();
        for (int i = 0; i < parts.size(); i++) {
            if (carrier(parts, i) == servo && parts.get(i) instanceof Servo) {
                for (int k = 0; k < parts.size(); k++) {
                    Solid solid = carrier(parts, k) == i ? shapes.get(parts.get(k)) : null;
                    if (solid != null) {
                        double mass = Math.max(LIGHT, ((Shape) parts.get(k)).getMass());
                        Pose place = ObjectPose.of(parts.get(k)).times(solid.offset);
                        into.add(solid.perKilogram().withMass(mass).inParent(place));
                    }
                }
                weigh(robot, i, shapes, into);
            }
        }
    }

    /** Makes and returns its body. */
    Body make(Body base, Pose... places) {
        body = new Body(base.name, masses, solids, places, base.getStart());
        return body;
    }

    public Body getBody() {
        return body;
    }
}
