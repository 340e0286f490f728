// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.Pose;
import org.SEAR.raycast.BeamScene;

/** Writes benchmark worlds as JSON with the results of SEAR and jbullet, for comparison with other engines. */
public final class WorldFiles {
    /** Number of boxes above which only {@link #FEW_POSES} poses are compared, as jbullet tests many boxes per ray. */
    private static final int MANY_BOXES = 2000;
    private static final int FEW_POSES = 10;
    /** Steps of the compared distance: 20 simulated seconds. */
    private static final int DRIVE_STEPS = 1200;

    private WorldFiles() {
    }

    /** @param args folder, then names of worlds */
    public static void main(String[] args) throws IOException {
        Path folder = Files.createDirectories(Paths.get(args[0]));
        for (String name : Arrays.copyOfRange(args, 1, args.length)) {
            Map<String, String> fields = new TreeMap<>();
            fields.put("name", '"' + name + '"');
            if (name.startsWith("drop")) {
                drop(name, fields);
            } else if (name.matches("(room|hall|hills)-.*")) {
                beams(new BeamWorld(name), fields);
            } else {
                drive(name, fields);
            }
            try (PrintWriter out = new PrintWriter(
                Files.newBufferedWriter(folder.resolve(name + ".json"), StandardCharsets.UTF_8))) {
                String separator = "{";
                for (Map.Entry<String, String> field : fields.entrySet()) {
                    out.print(separator + "\"" + field.getKey() + "\": " + field.getValue());
                    separator = ",\n";
                }
                out.println("}");
            }
        }
    }

    private static void beams(BeamWorld world, Map<String, String> fields) {
        fields.put("range", "" + BeamWorld.RANGE);
        fields.put("beams", "" + BeamWorld.BEAMS);
        fields.put("boxes", Arrays.deepToString(world.boxes));
        fields.put("vertices", world.triangles == null ? "[]" : Arrays.toString(world.triangles.vertices));
        fields.put("indices", world.triangles == null ? "[]" : Arrays.toString(world.triangles.indices));
        double[][] origins = new double[world.poses.length][];
        for (int i = 0; i < origins.length; i++) {
            origins[i] = new double[] {world.poses[i].x, world.poses[i].y, world.poses[i].z};
        }
        double[] directions = world.directions();
        fields.put("origins", Arrays.deepToString(origins));
        fields.put("directions", Arrays.toString(directions));
        fields.put("fan", ranges(world.ranges()));
        fields.put("single", ranges(single(world, origins, directions)));
        fields.put("jbullet", ranges(jbullet(world, origins, directions)));
    }

    /** Formats distances as JSON, -1 without a hit. */
    private static String ranges(double[] ranges) {
        return Arrays.toString(ranges).replace("Infinity", "-1");
    }

    private static double[] single(BeamWorld world, double[][] origins, double[] d) {
        BeamScene scene = world.scene();
        double[] all = new double[d.length / 3];
        for (int i = 0; i < all.length; i++) {
            double[] o = origins[i / BeamWorld.BEAMS];
            all[i] = scene.cast(o[0], o[1], o[2], d[3 * i], d[3 * i + 1], d[3 * i + 2], BeamWorld.RANGE,
                BeamScene.WORLD, null);
        }
        return all;
    }

    private static double[] jbullet(BeamWorld world, double[][] origins, double[] d) {
        JBulletWorld bullet = new JBulletWorld(world);
        double[] all = new double[world.boxes.length > MANY_BOXES ? FEW_POSES * BeamWorld.BEAMS : d.length / 3];
        Vector3f from = new Vector3f();
        Vector3f to = new Vector3f();
        for (int i = 0; i < all.length; i++) {
            double[] o = origins[i / BeamWorld.BEAMS];
            from.set((float) o[0], (float) o[1], (float) o[2]);
            to.set((float) (o[0] + BeamWorld.RANGE * d[3 * i]), (float) (o[1] + BeamWorld.RANGE * d[3 * i + 1]),
                (float) (o[2] + BeamWorld.RANGE * d[3 * i + 2]));
            float share = bullet.cast(from, to);
            all[i] = share < 1 ? share * BeamWorld.RANGE : Double.POSITIVE_INFINITY;
        }
        return all;
    }

    private static void drop(String name, Map<String, String> fields) {
        try (DropWorld world = new DropWorld(name)) {
            double[][] boxes = new double[world.boxes.length][];
            for (int i = 0; i < boxes.length; i++) {
                boxes[i] = Room.posed(world.boxes[i]);
            }
            fields.put("side", "" + world.side);
            fields.put("mass", "" + DropWorld.MASS);
            fields.put("steps", "" + DropWorld.STEPS);
            fields.put("boxes", Arrays.deepToString(boxes));
            fields.put("restSteps", "" + DropWorld.REST_STEPS);
            for (int i = 0; i < DropWorld.REST_STEPS; i++) {
                world.step();
            }
            fields.put("heights", Arrays.toString(world.heights()));
        }
    }

    private static void drive(String name, Map<String, String> fields) {
        Room room = StepWorld.room(name);
        double[][] boxes = new double[room.boxes.length][];
        for (int i = 0; i < boxes.length; i++) {
            boxes[i] = Room.posed(room.boxes[i]);
        }
        fields.put("side", "" + room.side);
        fields.put("boxes", Arrays.deepToString(boxes));
        fields.put("lidars", "" + StepWorld.lidars(name));
        fields.put("lidarHeight", "" + StepWorld.LIDAR_HEIGHT);
        fields.put("lidarPitch", "" + StepWorld.LIDAR_PITCH);
        fields.put("scanEvery", "" + StepWorld.SCAN_EVERY);
        fields.put("range", "" + StepWorld.RANGE);
        fields.put("circle", "" + StepWorld.CIRCLE);
        fields.put("speed", "" + StepWorld.SPEED);
        fields.put("startHeight", "" + StepWorld.START_HEIGHT);
        if (name.startsWith("drive")) {
            fields.put("checkSteps", "" + DRIVE_STEPS);
            fields.put("way", "" + way(name));
        }
    }

    /** Returns the distance driven by the robot, metres. */
    private static double way(String name) {
        try (StepWorld world = new StepWorld(name)) {
            double way = 0;
            Pose last = world.getSimulation().getPose("roomba");
            for (int i = 0; i < DRIVE_STEPS; i++) {
                world.step();
                Pose now = world.getSimulation().getPose("roomba");
                way += Math.hypot(now.x - last.x, now.z - last.z);
                last = now;
            }
            return way;
        }
    }
}
