// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** The boxes of a scene, with queries over all of them. */
final class Cuboids {
    private final List<Cuboid> all = new ArrayList<>();
    private final List<Pose> before = new ArrayList<>();
    private final List<Cuboid> order = new ArrayList<>();

    /** Adds a box with its sizes along its axes, metres. */
    void add(String name, double sizeX, double sizeY, double sizeZ) {
        Cuboid box = new Cuboid(name, sizeX, sizeY, sizeZ);
        all.add(box);
        order.add(box);
    }

    private void look(BodyRun run) {
        all.forEach(box -> box.place(run.pose(box.name)));
    }

    /** Returns the greatest penetration into another box or into a floor at height 0, metres. */
    double deepest(BodyRun run) {
        look(run);
        double deepest = 0;
        order.sort(Comparator.comparingDouble(box -> box.low(0)));
        for (int i = 0; i < order.size(); i++) {
            Cuboid box = order.get(i);
            double high = box.high(0);
            deepest = Math.max(deepest, -box.low(1));
            for (int k = i + 1; k < order.size() && order.get(k).low(0) <= high; k++) {
                deepest = Math.max(deepest, box.depth(order.get(k)));
            }
        }
        return deepest;
    }

    /** Returns the number of boxes more than a degree off every face. */
    int tilted(BodyRun run) {
        look(run);
        return (int) all.stream().filter(box -> box.flat() < Rest.FLAT).count();
    }

    /** Stores all poses. */
    void remember(BodyRun run) {
        before.clear();
        all.forEach(box -> before.add(run.pose(box.name)));
    }

    /** Returns the number of boxes that have moved since {@link #remember}. */
    int moving(BodyRun run) {
        int count = 0;
        for (int i = 0; i < all.size(); i++) {
            count += Rest.hasMoved(before.get(i), run.pose(all.get(i).name)) ? 1 : 0;
        }
        return count;
    }

    /** Returns the greatest speed, m/s. */
    double fastest(BodyRun run) {
        return all.stream().mapToDouble(box -> Rest.speed(run.velocities(box.name))).max().orElse(0);
    }
}
