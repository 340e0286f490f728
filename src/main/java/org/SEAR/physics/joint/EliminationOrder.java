// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * Order in which joints are eliminated: always the one with the fewest neighbours (minimum degree), so that chains and
 * trees cause no fill-in. Joints are neighbours if they act on a common movable body.
 */
final class EliminationOrder {
    private final List<Joint> order = new ArrayList<>();
    private int couplings;

    /** @param joints equal ones keep their order */
    EliminationOrder(List<Joint> joints) {
        List<Set<Integer>> neighbours = new ArrayList<>();
        for (int i = 0; i < joints.size(); i++) {
            Set<Integer> near = new TreeSet<>();
            for (int k = 0; k < joints.size(); k++) {
                if (k != i && isNear(joints.get(i), joints.get(k))) {
                    near.add(k);
                }
            }
            neighbours.add(near);
        }
        Set<Integer> left = new TreeSet<>();
        for (int i = 0; i < joints.size(); i++) {
            left.add(i);
        }
        while (!left.isEmpty()) {
            int next = left.iterator().next();
            for (int i : left) {
                next = neighbours.get(i).size() < neighbours.get(next).size() ? i : next;
            }
            left.remove(next);
            order.add(joints.get(next));
            couplings += neighbours.get(next).size();
            eliminate(next, neighbours);
        }
    }

    List<Joint> getJoints() {
        return order;
    }

    /** Number of neighbours that the joints had when they were eliminated. */
    int getCouplings() {
        return couplings;
    }

    /** The neighbours of an eliminated joint become neighbours of each other. */
    private static void eliminate(int joint, List<Set<Integer>> neighbours) {
        Set<Integer> near = neighbours.get(joint);
        for (int i : near) {
            neighbours.get(i).addAll(near);
            neighbours.get(i).remove(i);
            neighbours.get(i).remove(joint);
        }
    }

    private static boolean isNear(Joint one, Joint other) {
        for (JointedBody a : one.ends()) {
            for (JointedBody b : other.ends()) {
                if (a == b && a.inverseMass > 0) {
                    return true;
                }
            }
        }
        return false;
    }
}
