// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.physics.joint.Joint;
import org.SEAR.physics.joint.Mechanism;

/** Movable bodies that joints connect, and their mechanism. Simulation thread. */
final class JointedBodies {
    final List<Body> bodies = new ArrayList<>();
    final Mechanism mechanism;
    /** Whether a joint connects them with a body that never moves, or with the world. */
    final boolean held;

    private JointedBodies(List<Link> links) {
        List<Joint> joints = new ArrayList<>();
        boolean fixed = false;
        for (Link link : links) {
            joints.add(link.joint);
            for (Body body : link.ends) {
                if (body != null && !body.isFixed()) {
                    if (!bodies.contains(body)) {
                        bodies.add(body);
                    }
                } else {
                    fixed = true;
                }
            }
        }
        held = fixed;
        mechanism = new Mechanism(joints);
    }

    /** A joint and the bodies on which it acts; null for the world. */
    static final class Link {
        final Joint joint;
        final Body[] ends;

        Link(Joint joint, Body... ends) {
            this.joint = joint;
            this.ends = ends;
        }

        /** Whether a body is one of its ends and it is not broken. */
        boolean holds(Body body) {
            return !joint.isBroken() && (ends[0] == body || ends[1] == body);
        }

        boolean isConnected(List<Link> others) {
            for (Link other : others) {
                for (Body body : other.ends) {
                    for (Body own : ends) {
                        if (own != null && own == body && !own.isFixed()) {
                            return true;
                        }
                    }
                }
            }
            return false;
        }
    }

    /** Groups joints by the movable bodies that they share. */
    static List<JointedBodies> of(List<Link> links) {
        List<List<Link>> groups = new ArrayList<>();
        for (Link link : links) {
            List<Link> together = new ArrayList<>();
            for (int i = groups.size() - 1; i >= 0; i--) {
                if (link.isConnected(groups.get(i))) {
                    together.addAll(0, groups.remove(i));
                }
            }
            together.add(link);
            groups.add(together);
        }
        List<JointedBodies> all = new ArrayList<>();
        for (List<Link> group : groups) {
            all.add(new JointedBodies(group));
        }
        return all;
    }

    /** Returns the first body that moves in this step; null if there is none. */
    Body firstSolved() {
        for (int i = 0; i < bodies.size(); i++) {
            if (bodies.get(i).isSolved()) {
                return bodies.get(i);
            }
        }
        return null;
    }

    /** Begins a step. */
    void begin() {
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).getSolver().movable = bodies.get(i).isSolved();
        }
        mechanism.beginStep();
    }
}
