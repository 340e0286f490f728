// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import com.bulletphysics.collision.broadphase.DbvtBroadphase;
import com.bulletphysics.collision.dispatch.CollisionDispatcher;
import com.bulletphysics.collision.dispatch.DefaultCollisionConfiguration;
import com.bulletphysics.collision.shapes.BoxShape;
import com.bulletphysics.collision.shapes.CollisionShape;
import com.bulletphysics.collision.shapes.CylinderShape;
import com.bulletphysics.dynamics.DiscreteDynamicsWorld;
import com.bulletphysics.dynamics.RigidBody;
import com.bulletphysics.dynamics.constraintsolver.SequentialImpulseConstraintSolver;
import com.bulletphysics.linearmath.DefaultMotionState;
import com.bulletphysics.linearmath.Transform;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import javax.vecmath.Quat4f;
import javax.vecmath.Vector3f;

/**
 * Boxes or cylinders on a floor in jbullet with its default settings, at 1/60 s: measures the thread's processor time
 * and writes the final poses. Shows what contacts of jbullet would be like in SEAR, which solves its own.
 */
public final class JBulletBodies {
    private static final float STEP = 1 / 60f;
    private static final float GRAVITY = 9.81f;
    /** Largest margin, as a share of the smallest half extent: a margin larger than a box turns it inside out. */
    private static final double MARGIN_SHARE = 0.3;

    private final List<RigidBody> bodies = new ArrayList<>();
    private final DiscreteDynamicsWorld world;

    private JBulletBodies(List<double[]> numbers) {
        DefaultCollisionConfiguration configuration = new DefaultCollisionConfiguration();
        world = new DiscreteDynamicsWorld(new CollisionDispatcher(configuration), new DbvtBroadphase(),
            new SequentialImpulseConstraintSolver(), configuration);
        world.setGravity(new Vector3f(0, -GRAVITY, 0));
        double[] head = numbers.get(0);
        float side = (float) head[0] / 2;
        add(new BoxShape(new Vector3f(side, 0.05f, side)), 0, head[2], new double[] {0, 0, 0, 0, -0.05, 0, 0, 0, 0, 1});
        for (double[] b : numbers.subList(1, numbers.size())) {
            Vector3f half = new Vector3f((float) b[0], (float) b[1], (float) b[2]);
            CollisionShape shape = head[5] > 0 ? new CylinderShape(half) : new BoxShape(half);
            shape.setMargin((float) Math.min(shape.getMargin(), MARGIN_SHARE * Math.min(b[0], Math.min(b[1], b[2]))));
            bodies.add(add(shape, (float) head[1], head[2], b));
        }
    }

    /** Adds a body; jbullet multiplies both coefficients of friction. */
    private RigidBody add(CollisionShape shape, float mass, double friction, double[] b) {
        Vector3f inertia = new Vector3f();
        if (mass > 0) {
            shape.calculateLocalInertia(mass, inertia);
        }
        Transform at = new Transform();
        at.setIdentity();
        at.setRotation(new Quat4f((float) b[6], (float) b[7], (float) b[8], (float) b[9]));
        at.origin.set((float) b[3], (float) b[4], (float) b[5]);
        RigidBody body = new RigidBody(mass, new DefaultMotionState(at), shape, inertia);
        body.setFriction((float) Math.sqrt(friction));
        world.addRigidBody(body);
        return body;
    }

    private double run(double seconds) {
        long from = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        for (long i = Math.round(seconds / STEP); i > 0; i--) {
            world.stepSimulation(STEP, 0);
        }
        return (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - from) * 1e-9;
    }

    private double[][] poses() {
        double[][] poses = new double[bodies.size()][];
        Quat4f turned = new Quat4f();
        for (int i = 0; i < poses.length; i++) {
            Transform at = bodies.get(i).getWorldTransform(new Transform());
            at.getRotation(turned);
            poses[i] = new double[] {at.origin.x, at.origin.y, at.origin.z, turned.x, turned.y, turned.z, turned.w};
        }
        return poses;
    }

    /**
     * @param args a file of numbers (side, mass, friction, seconds, watch, round; then ten per body), and the file for
     *     the result
     */
    public static void main(String[] args) throws IOException {
        List<double[]> numbers = new ArrayList<>();
        for (String line : Files.readAllLines(Paths.get(args[0]))) {
            numbers.add(Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray());
        }
        JBulletBodies bodies = new JBulletBodies(numbers);
        double watch = numbers.get(0)[4];
        double took = bodies.run(numbers.get(0)[3] - watch);
        double[][] before = bodies.poses();
        took += bodies.run(watch);
        Files.writeString(Paths.get(args[1]),
            String.format(Locale.ROOT, "{\"cpu\": %s, \"before\": %s, \"after\": %s}%n", took,
            Arrays.deepToString(before), Arrays.deepToString(bodies.poses())));
    }
}
