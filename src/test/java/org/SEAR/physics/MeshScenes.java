// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Sphere;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/**
 * Bodies sliding and rolling over inner edges of a mesh, compared with closed forms. The mesh is a plane along x, 2 m
 * wide, that rises from x = 0 on.
 */
final class MeshScenes {
    private static final double G = 9.81;
    private static final double RADIUS = 0.1;

    private MeshScenes() {
    }

    /** Makes a model of two planes of triangles without friction. */
    static Model ground(Stage stage, int cells, double degrees) throws IOException {
        StringBuilder obj = new StringBuilder();
        double up = Math.toRadians(degrees);
        for (int i = 0; i <= 2 * cells; i++) {
            double along = 4.0 * (i - cells) / cells;
            for (int k = 0; k <= cells; k++) {
                obj.append(String.format(Locale.ROOT, "v %.6f %.6f %.6f%n", along > 0 ? along * Math.cos(up) : along,
                    Math.max(0, along) * Math.sin(up), 2.0 * k / cells - 1));
            }
        }
        for (int i = 0; i < 2 * cells; i++) {
            for (int k = 0; k < cells; k++) {
                int at = i * (cells + 1) + k + 1;
                int next = at + cells + 1;
                obj.append(String.format(Locale.ROOT, "f %d %d %d%nf %d %d %d%n", at, at + 1, next, at + 1,
                    next + 1, next));
            }
        }
        Path assets = Files.createDirectories(stage.folder().resolve("assets"));
        Files.write(assets.resolve("ground.obj"), obj.toString().getBytes(StandardCharsets.UTF_8));
        Model ground = new Model("ground", "ground.obj");
        ground.setRollingFriction(0);
        ground.setFriction(2);
        return ground;
    }

    private static void throwOver(Shape thing, double speed) {
        thing.move(-3, RADIUS, 0.13);
        thing.setRollingFriction(0);
        thing.setVelocity(speed, 0, 0);
    }

    /** A ball rolls, or a box slides without friction, over the plane: straight on and at the same speed. */
    static void over(boolean ball, int cells, Findings into) throws Exception {
        try (Stage stage = new Stage()) {
            ground(stage, cells, 0);
            Shape thing = ball ? new Sphere("thing", RADIUS, 1)
                : new Box("thing", 2 * RADIUS, 2 * RADIUS, 2 * RADIUS, 1);
            throwOver(thing, 1);
            if (ball) {
                thing.setSpin(0, 0, -Math.toDegrees(1 / RADIUS));
            } else {
                thing.setFriction(0);
            }
            BodyRun run = stage.start();
            run.run(5);
            Pose to = run.pose("thing");
            into.in((ball ? "ball" : "box") + " over " + cells + " x " + cells + " cells");
            into.within("way, m", 5, 1e-3, to.x + 3);
            into.within("beside the middle, m", 0.13, 1e-3, to.z);
            into.within("height, m", RADIUS, 2e-3, to.y);
        }
    }

    /**
     * A ball rolls on without slipping where the ground rises: its angular momentum about the new contact point is
     * conserved.
     */
    static void up(double degrees, double speed, int cells, Findings into) throws Exception {
        try (Stage stage = new Stage()) {
            ground(stage, cells, degrees);
            Sphere ball = new Sphere("thing", RADIUS, 1);
            throwOver(ball, speed);
            ball.setFriction(2);
            ball.setSpin(0, 0, -Math.toDegrees(speed / RADIUS));
            BodyRun run = stage.start();
            double highest = 0;
            for (int i = 0; i < 240; i++) {
                run.run(1 / 60.0);
                highest = Math.max(highest, run.pose("thing").y);
            }
            double kept = speed * (5 * Math.cos(Math.toRadians(degrees)) + 2) / 7;
            into.in("ball up " + degrees + " degrees over " + cells + " x " + cells + " cells");
            into.within("rises, m", 0.7 * kept * kept / G, 0.02, highest - RADIUS);
        }
    }
}
