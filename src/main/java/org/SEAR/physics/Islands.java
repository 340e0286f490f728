// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.List;

/**
 * Divides the movable bodies into islands. Bodies that touch, that joints connect, or that wheels press on, are solved
 * together and sleep together. Fixed bodies connect nothing. Union-find (Tarjan 1975) over the pairs; islands are in
 * the order of their first bodies. Simulation thread.
 */
final class Islands {
    private int[] parent = {};
    private final List<Island> all = new ArrayList<>();
    private int count;
    private Island[] ofRoot = {};

    /** Bodies that touch each other. */
    static final class Island {
        final List<Body> bodies = new ArrayList<>();
        final List<PairContacts> pairs = new ArrayList<>();
        final List<IslandSolver.WheelDrive> drives = new ArrayList<>();
        final List<JointedBodies> mechanisms = new ArrayList<>();
    }

    /**
     * Rebuilds the islands.
     * @param bodies movable bodies, in the order of their numbers
     * @param total number of bodies in the world
     */
    void build(List<Body> bodies, List<PairContacts> pairs, List<IslandSolver.WheelDrive> drives,
            List<JointedBodies> mechanisms, int total) {
        if (parent.length < total) {
            parent = new int[total];
            ofRoot = new Island[total];
        }
        for (int i = 0; i < bodies.size(); i++) {
            int number = bodies.get(i).number;
            parent[number] = number;
            ofRoot[number] = null;
        }
        for (int i = 0; i < pairs.size(); i++) {
            PairContacts pair = pairs.get(i);
            if (pair.getA().isSolved() && pair.getB().isSolved()) {
                join(pair.getA().number, pair.getB().number);
            }
        }
        for (int i = 0; i < drives.size(); i++) {
            join(drives.get(i).body, drives.get(i).drive.loaded());
        }
        for (int i = 0; i < mechanisms.size(); i++) {
            Body first = mechanisms.get(i).firstSolved();
            for (int k = 0; k < mechanisms.get(i).bodies.size(); k++) {
                Body body = mechanisms.get(i).bodies.get(k);
                if (body.isSolved()) {
                    join(first.number, body.number);
                }
            }
        }
        count = 0;
        for (int i = 0; i < bodies.size(); i++) {
            Body body = bodies.get(i);
            if (body.isSolved()) {
                of(body).bodies.add(body);
            }
        }
        for (int i = 0; i < pairs.size(); i++) {
            PairContacts pair = pairs.get(i);
            if (pair.getA().isSolved() || pair.getB().isSolved()) {
                of(pair.getA().isSolved() ? pair.getA() : pair.getB()).pairs.add(pair);
            }
        }
        for (int i = 0; i < drives.size(); i++) {
            if (drives.get(i).body.isSolved()) {
                of(drives.get(i).body).drives.add(drives.get(i));
            }
        }
        for (int i = 0; i < mechanisms.size(); i++) {
            Body first = mechanisms.get(i).firstSolved();
            if (first != null) {
                of(first).mechanisms.add(mechanisms.get(i));
            }
        }
    }

    private Island of(Body body) {
        int root = root(body.number);
        if (ofRoot[root] == null) {
            if (count == all.size()) {
                all.add(new Island());
            }
            Island island = all.get(count++);
            island.bodies.clear();
            island.pairs.clear();
            island.drives.clear();
            island.mechanisms.clear();
            ofRoot[root] = island;
        }
        return ofRoot[root];
    }

    private void join(Body robot, List<Body> others) {
        for (int i = 0; i < others.size() && robot.isSolved(); i++) {
            if (others.get(i).isSolved()) {
                join(robot.number, others.get(i).number);
            }
        }
    }

    /** The smaller number becomes the root, so that islands are in the order of their first bodies. */
    private void join(int one, int other) {
        int a = root(one);
        int b = root(other);
        parent[Math.max(a, b)] = Math.min(a, b);
    }

    private int root(int number) {
        int at = number;
        while (parent[at] != at) {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        return at;
    }

    int size() {
        return count;
    }

    Island get(int i) {
        return all.get(i);
    }
}
