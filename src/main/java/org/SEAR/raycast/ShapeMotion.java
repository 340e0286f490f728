// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import java.util.Arrays;
import org.SEAR.geometry.Rotation;

/**
 * Poses of a scene's moving shapes in the latest steps, and those between them: within a step the origin of a shape
 * moves straight, and the shape turns about a fixed axis at constant speed. After the last step both continue for at
 * most one step. The simulation thread writes between two casts; any number of threads read.
 */
final class ShapeMotion {
    /** Remembered steps, two seconds. */
    private static final int STEPS = 121;
    private static final int POSE = Shapes.POSE;
    /** Largest movement of a shape at rest: metres, and components of a unit quaternion. */
    private static final double REST = 1e-6;
    private static final int NONE = -1;
    private static final long NEVER = -1;

    /** The shapes that do not move, with the numbers of all shapes. */
    final Shapes still = new Shapes();
    /** Number of moving shapes. */
    int count;
    private final Shapes shapes;
    /** Shape, last step of movement, radius about the origin in metres, and remembered poses of each moving shape. */
    private int[] moving = new int[16];
    private long[] movedAt = new long[16];
    private double[] radii = new double[16];
    private double[] rings = new double[16 * STEPS * POSE];
    /** Index of each shape among the moving ones, or {@link #NONE}. */
    private int[] indices = new int[0];
    /** Poses of all shapes at the end of their last movement. */
    private double[] known = new double[0];
    private long first;
    private long last = NEVER;
    private long lastMove = NEVER;

    ShapeMotion(Shapes shapes) {
        this.shapes = shapes;
    }

    /** Forgets all movement, as after a teleport: shapes have always been where they are. */
    void forget(double[] poses) {
        count = 0;
        last = NEVER;
        lastMove = NEVER;
        known = Arrays.copyOf(poses, shapes.count * POSE);
        indices = new int[shapes.count];
        Arrays.fill(indices, NONE);
        share();
    }

    /** Takes over visibility and changed shapes of the scene. */
    void share() {
        still.share(shapes);
        for (int i = 0; i < count; i++) {
            still.visible[moving[i]] = false;
        }
    }

    /** Remembers the poses of a step. */
    void add(long step, double[] poses) {
        if (step == last) {
            return;
        }
        if (known.length != shapes.count * POSE || last != NEVER && step != last + 1) {
            forget(poses);
        }
        if (last == NEVER) {
            first = step - 1;
        }
        last = step;
        first = Math.max(first, step - STEPS + 1);
        for (int shape = 0; shape < shapes.count; shape++) {
            if (hasMoved(poses, shape * POSE)) {
                move(shape);
                System.arraycopy(poses, shape * POSE, known, shape * POSE, POSE);
            }
        }
        for (int i = count - 1; i >= 0; i--) {
            if (movedAt[i] <= first) {
                remove(i);
            } else {
                System.arraycopy(known, moving[i] * POSE, rings, slot(i, step), POSE);
            }
        }
    }

    private boolean hasMoved(double[] poses, int at) {
        for (int i = at; i < at + POSE; i++) {
            if (Math.abs(known[i] - poses[i]) > REST) {
                return true;
            }
        }
        return false;
    }

    private void move(int shape) {
        if (indices[shape] == NONE) {
            include(shape);
        }
        movedAt[indices[shape]] = last;
        lastMove = last;
    }

    /** Starts to remember a shape, which has been at rest until the step before. */
    private void include(int shape) {
        if (count == moving.length) {
            moving = Arrays.copyOf(moving, 2 * count);
            movedAt = Arrays.copyOf(movedAt, 2 * count);
            radii = Arrays.copyOf(radii, 2 * count);
            rings = Arrays.copyOf(rings, 2 * count * STEPS * POSE);
        }
        moving[count] = shape;
        radii[count] = shapes.radius(shape);
        indices[shape] = count;
        for (int step = 0; step < STEPS; step++) {
            System.arraycopy(known, shape * POSE, rings, slot(count, step), POSE);
        }
        still.visible[shape] = false;
        count++;
    }

    private void remove(int index) {
        int shape = moving[index];
        indices[shape] = NONE;
        still.visible[shape] = shapes.visible[shape];
        count--;
        if (index < count) {
            moving[index] = moving[count];
            movedAt[index] = movedAt[count];
            radii[index] = radii[count];
            indices[moving[index]] = index;
            System.arraycopy(rings, slot(count, 0), rings, slot(index, 0), STEPS * POSE);
        }
    }

    private static int slot(int index, long step) {
        return (index * STEPS + (int) (step % STEPS)) * POSE;
    }

    /** Returns the number of a moving shape in the scene. */
    int shape(int index) {
        return moving[index];
    }

    boolean isSeen(int shape, int ignoredOwner) {
        return shapes.isSeen(shape, ignoredOwner);
    }

    /** Returns whether a shape has moved after a time, or continues to move until a later one; both in steps. */
    boolean hasMoved(double since, double until) {
        return lastMove > since || lastMove == last && last != NEVER && until > last;
    }

    private long from(double time) {
        return Math.max(first, Math.min(last - 1, (long) Math.floor(time)));
    }

    /** Returns whether a ray of at most a length touches the sphere around a moving shape at a time, in steps. */
    boolean isNear(int index, double time, double ox, double oy, double oz, double dx, double dy, double dz,
        double length) {
        long from = from(time);
        double part = Math.max(0, Math.min(2, time - from));
        int a = slot(index, from);
        int b = slot(index, from + 1);
        double x = rings[a] + part * (rings[b] - rings[a]) - ox;
        double y = rings[a + 1] + part * (rings[b + 1] - rings[a + 1]) - oy;
        double z = rings[a + 2] + part * (rings[b + 2] - rings[a + 2]) - oz;
        double along = x * dx + y * dy + z * dz;
        double radius = radii[index];
        return x * x + y * y + z * z - along * along <= radius * radius && along >= -radius && along - radius <= length;
    }

    /** Writes the frame of a moving shape at a time, in steps, as {@link Shapes#data} has it. */
    void place(int index, double time, Rotation rotation, double[] frame) {
        long from = from(time);
        double part = Math.max(0, Math.min(2, time - from));
        int a = slot(index, from);
        int b = slot(index, from + 1);
        rotation.between(rings[a + 3], rings[a + 4], rings[a + 5], rings[a + 6], rings[b + 3], rings[b + 4],
            rings[b + 5], rings[b + 6], part).write(frame);
        for (int k = 0; k < 3; k++) {
            frame[Shapes.POSITION + k] = rings[a + k] + part * (rings[b + k] - rings[a + k]);
        }
        System.arraycopy(shapes.data, moving[index] * Shapes.STRIDE + Shapes.SIZE, frame, Shapes.SIZE, 3);
    }
}
