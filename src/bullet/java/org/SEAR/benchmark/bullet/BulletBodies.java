// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark.bullet;

import com.jme3.bullet.PhysicsSpace;
import com.jme3.bullet.collision.shapes.BoxCollisionShape;
import com.jme3.bullet.collision.shapes.CollisionShape;
import com.jme3.bullet.collision.shapes.CylinderCollisionShape;
import com.jme3.bullet.objects.PhysicsRigidBody;
import com.jme3.math.Quaternion;
import com.jme3.math.Vector3f;
import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Boxes or cylinders on a floor in native Bullet with its default settings, at 1/60 s: measures the thread's processor
 * time and writes the final poses.
 */
public final class BulletBodies {
    private static final String LIBRARY = "/native/linux/x86_64/libbulletjme.so";
    private static final float STEP = 1 / 60f;
    private static final float GRAVITY = 9.81f;
    /** Largest margin, as a share of the smallest half extent: a margin larger than a box turns it inside out. */
    private static final double MARGIN_SHARE = 0.3;

    private final List<PhysicsRigidBody> bodies = new ArrayList<>();
    private final PhysicsSpace space = new PhysicsSpace(PhysicsSpace.BroadphaseType.DBVT);

    private BulletBodies(List<double[]> numbers) {
        double[] head = numbers.get(0);
        space.setGravity(new Vector3f(0, -GRAVITY, 0));
        space.setAccuracy(STEP);
        float side = (float) head[0] / 2;
        PhysicsRigidBody floor = new PhysicsRigidBody(new BoxCollisionShape(side, 0.05f, side), 0);
        floor.setPhysicsLocation(new Vector3f(0, -0.05f, 0));
        add(floor, head[2]);
        for (double[] b : numbers.subList(1, numbers.size())) {
            Vector3f half = new Vector3f((float) b[0], (float) b[1], (float) b[2]);
            CollisionShape shape = head[5] > 0 ? new CylinderCollisionShape(half, PhysicsSpace.AXIS_Y)
                : new BoxCollisionShape(half);
            shape.setMargin((float) Math.min(shape.getMargin(), MARGIN_SHARE * Math.min(b[0], Math.min(b[1], b[2]))));
            PhysicsRigidBody body = new PhysicsRigidBody(shape, (float) head[1]);
            body.setPhysicsLocation(new Vector3f((float) b[3], (float) b[4], (float) b[5]));
            body.setPhysicsRotation(new Quaternion((float) b[6], (float) b[7], (float) b[8], (float) b[9]));
            add(body, head[2]);
            bodies.add(body);
        }
    }

    /** Bullet multiplies both coefficients of friction. */
    private void add(PhysicsRigidBody body, double friction) {
        body.setFriction((float) Math.sqrt(friction));
        space.addCollisionObject(body);
    }

    private double run(double seconds) {
        long from = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        for (long i = Math.round(seconds / STEP); i > 0; i--) {
            space.update(STEP, 0);
        }
        return (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - from) * 1e-9;
    }

    private double[][] poses() {
        double[][] poses = new double[bodies.size()][];
        Vector3f at = new Vector3f();
        Quaternion turned = new Quaternion();
        for (int i = 0; i < poses.length; i++) {
            bodies.get(i).getPhysicsLocation(at);
            bodies.get(i).getPhysicsRotation(turned);
            poses[i] = new double[] {at.x, at.y, at.z, turned.getX(), turned.getY(), turned.getZ(), turned.getW()};
        }
        return poses;
    }

    private static void load() throws IOException {
        Path file = Files.createTempFile("bullet", ".so");
        try (InputStream in = BulletBodies.class.getResourceAsStream(LIBRARY)) {
            Files.copy(in, file, StandardCopyOption.REPLACE_EXISTING);
        }
        System.load(file.toString());
        Files.delete(file);
    }

    /**
     * @param args a file of numbers (side, mass, friction, seconds, watch, round; then ten per body), and the file for
     *     the result
     */
    public static void main(String[] args) throws IOException {
        load();
        List<double[]> numbers = new ArrayList<>();
        for (String line : Files.readAllLines(Paths.get(args[0]))) {
            numbers.add(Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray());
        }
        BulletBodies world = new BulletBodies(numbers);
        double watch = numbers.get(0)[4];
        double took = world.run(numbers.get(0)[3] - watch);
        double[][] before = world.poses();
        took += world.run(watch);
        Files.writeString(Paths.get(args[1]),
            String.format(Locale.ROOT, "{\"cpu\": %s, \"before\": %s, \"after\": %s}%n", took,
            Arrays.deepToString(before), Arrays.deepToString(world.poses())));
    }
}
