// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.solid.MassProperties;
import org.SEAR.physics.solid.Solid;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.PartCarriers;

/**
 * Parts of a robot that one servo or joint moves, as a body. Its frame is that of the robot while the servo or joint is
 * at its start, and moves with it. Simulation thread.
 */
public final class RobotLink {
    /** Mass of the shapes of a link if none of them has a mass, kg. */
    private static final double LIGHT = 0.001;
    /** Smallest mass of a link as a share of the links that it carries: lighter ones can't be solved. */
    private static final double MIN_SHARE = 0.001;

    /** Number of its servo or joint among the components. */
    final int mover;
    /** Link that carries it; null for the robot's own body. */
    final RobotLink carrier;
    /** Its shapes. */
    final List<Solid> solids = new ArrayList<>();
    /** In the robot's frame with all servos and joints at their start. */
    final MassProperties masses;
    private Body body;

    private RobotLink(Parts parts, int mover, RobotLink carrier) {
        this.mover = mover;
        this.carrier = carrier;
        List<MassProperties> heavy = new ArrayList<>();
        List<MassProperties> light = new ArrayList<>();
        for (int i = 0; i < parts.all.size(); i++) {
            Solid solid = parts.movers.mover(i) == mover ? parts.solid(i) : null;
            if (solid != null) {
                solids.add(solid);
                MassProperties unit = solid.perKilogram().inParent(parts.place(i));
                double mass = ((Shape) parts.all.get(i)).getMass();
                (mass > 0 ? heavy : light).add(unit.withMass(mass > 0 ? mass : solid.volume()));
            }
        }
        List<MassProperties> carried = new ArrayList<>();
        parts.weigh(mover, carried);
        double least = carried.isEmpty() ? LIGHT : Math.max(LIGHT, MIN_SHARE * MassProperties.sum(carried).mass);
        MassProperties own = MassProperties.sum(!heavy.isEmpty() ? heavy : !light.isEmpty() ? light : carried);
        masses = own.withMass(heavy.isEmpty() ? least : Math.max(least, own.mass));
    }

    /** Returns the links of a robot, each after the one that carries it. */
    static List<RobotLink> of(SEARrobot robot, Map<SearObject, Solid> shapes) {
        List<RobotLink> all = new ArrayList<>();
        add(new Parts(robot, shapes), PartCarriers.NONE, null, all);
        return all;
    }

    private static void add(Parts parts, int on, RobotLink carrier, List<RobotLink> all) {
        for (int i = 0; i < parts.all.size(); i++) {
            if (parts.isCarriedBy(i, on) && parts.movesShapes(i)) {
                RobotLink link = new RobotLink(parts, i, carrier);
                all.add(link);
                add(parts, i, link, all);
            }
        }
    }

    /** Components of a robot, and what moves them. */
    private static final class Parts {
        final List<SearObject> all;
        final PartCarriers movers;
        private final Map<SearObject, Solid> shapes;

        Parts(SEARrobot robot, Map<SearObject, Solid> shapes) {
            all = robot.getComponents();
            movers = new PartCarriers(all);
            this.shapes = shapes;
        }

        /** Returns the solid of a component; null for one without a shape. */
        Solid solid(int part) {
            return shapes.get(all.get(part));
        }

        /** Returns the pose of a component's solid in the robot's frame. */
        Pose place(int part) {
            return ObjectPose.of(all.get(part)).times(solid(part).offset);
        }

        /** Whether a component is a servo, or a joint that moves parts, and another one carries it. */
        boolean isCarriedBy(int part, int mover) {
            return movers.moves(part) && movers.carrier(part) == mover;
        }

        /** Whether a servo or joint, or one that it carries, moves a shape. */
        boolean movesShapes(int mover) {
            for (int i = 0; i < all.size(); i++) {
                if (movers.mover(i) == mover && solid(i) != null || isCarriedBy(i, mover) && movesShapes(i)) {
                    return true;
                }
            }
            return false;
        }

        /** Collects the masses of all shapes that those move which a servo or joint carries, in the robot's frame. */
        void weigh(int mover, List<MassProperties> into) {
            for (int i = 0; i < all.size(); i++) {
                if (isCarriedBy(i, mover)) {
                    for (int k = 0; k < all.size(); k++) {
                        if (movers.mover(k) == i && solid(k) != null) {
                            double mass = Math.max(LIGHT, ((Shape) all.get(k)).getMass());
                            into.add(solid(k).perKilogram().withMass(mass).inParent(place(k)));
                        }
                    }
                    weigh(i, into);
                }
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
