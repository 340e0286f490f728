// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/**
 * Bodies at the limits of sliding and of tipping over: placed on slopes that fall towards -x, and under a push that
 * grows slowly, which acts on them as a slope that is slowly tilted.
 */
final class ThresholdScenes {
    private static final double G = 9.81;
    /** Friction coefficient of contacts that must not slide, and of those that must not tip. */
    private static final double ROUGH = 4;
    private static final double SMOOTH = 0.25;
    /** Default friction coefficient of wheels. */
    private static final double WHEEL_FRICTION = 1.25;
    /** Largest difference of a slope from its closed form, degrees. */
    private static final double OFF = 0.1;
    /** Largest relative difference of a push from its closed form. */
    private static final double SHARE = 0.01;
    /** Movements above which a body has slid, metres, or tipped over, degrees. */
    private static final double SLID = 1e-3;
    private static final double TIPPED = 5;
    /** Movements of a body that friction holds, metres, and that stands, degrees. */
    private static final double HOLDS = 2e-4;
    private static final double STANDS = 0.05;

    /** Sides of the prism. */
    private static final int SIDES = 7;

    private ThresholdScenes() {
    }

    /** A kind of body that stands on its base. */
    enum Kind {
        BOX(0.05, 0.2, 0.1), CYLINDER(0.05, 0.2, 0.1), CONE(0.04, 0.36, 0.09), PRISM(0.05, 0.2, 0.1);

        /** Half of the base (of a prism the radius of its incircle), height, height of the centre of mass, metres. */
        private final double half;
        private final double height;
        private final double centre;

        Kind(double half, double height, double centre) {
            this.half = half;
            this.height = height;
            this.centre = centre;
        }

        private Shape make(Stage stage) throws IOException {
            if (this == PRISM) {
                return prism(stage);
            }
            return this == BOX ? new Box("thing", 2 * half, 2 * half, height, 1)
                : this == CYLINDER ? new Cylinder("thing", half, height, 1) : new Cone("thing", half, height, 1);
        }

        /** Returns a prism with one edge of its base towards -x. */
        private Shape prism(Stage stage) throws IOException {
            StringBuilder obj = new StringBuilder();
            StringBuilder sides = new StringBuilder();
            StringBuilder base = new StringBuilder("f");
            StringBuilder top = new StringBuilder("f");
            for (int i = 0; i < SIDES; i++) {
                double angle = Math.PI + 2 * Math.PI * (i + 0.5) / SIDES;
                double radius = half / Math.cos(Math.PI / SIDES);
                for (int k = -1; k <= 1; k += 2) {
                    obj.append(String.format(Locale.ROOT, "v %.9f %.9f %.9f%n", radius * Math.cos(angle),
                        k * height / 2, radius * Math.sin(angle)));
                }
                base.append(" ").append(2 * i + 1);
                top.insert(1, " " + (2 * i + 2));
                int next = (i + 1) % SIDES;
                sides.append(String.format("f %d %d %d %d%n", 2 * i + 1, 2 * i + 2, 2 * next + 2, 2 * next + 1));
            }
            Path assets = Files.createDirectories(stage.folder().resolve("assets"));
            Files.write(assets.resolve("prism.obj"), (obj + "" + sides + base + "\n" + top + "\n")
                .getBytes(StandardCharsets.UTF_8));
            return new Model("thing", "prism.obj", 1);
        }

        /**
         * Returns the tangent of the slope on which it tips over.
         * @param yaw of its base against the slope, degrees
         */
        private double tips(double yaw) {
            double turned = Math.toRadians(yaw);
            if (this == PRISM) {
                double side = 2 * Math.PI / SIDES;
                return half / centre / Math.cos(turned - side * Math.round(turned / side));
            }
            return half / centre / (this == BOX ? Math.max(Math.abs(Math.cos(turned)), Math.abs(Math.sin(turned))) : 1);
        }
    }

    private static void put(Stage stage, Kind kind, double degrees, double yaw, double friction, boolean onMesh)
        throws IOException {
        Shape floor = onMesh ? MeshScenes.ground(stage, 8, 0) : new Floor("floor", 100, 100);
        floor.rotate(0, 0, degrees);
        floor.setFriction(Math.sqrt(friction));
        Shape thing = kind.make(stage);
        thing.setFriction(Math.sqrt(friction));
        Pose pose = Pose.ofDegrees(0, 0, 0, 0, 0, degrees)
            .times(Pose.ofDegrees(0.07, kind.height / 2, 0.03, 0, yaw, 0));
        double[] turned = RollingScenes.degrees(pose);
        thing.move(pose.x, pose.y, pose.z);
        thing.rotate(turned[0], turned[1], turned[2]);
    }

    /** Places a body at rest on a slope; returns {distance travelled, m; turned, degrees; speed, m/s}. */
    private static double[] place(Kind kind, double degrees, double yaw, double friction, boolean onMesh,
        double seconds) throws Exception {
        try (Stage stage = new Stage()) {
            put(stage, kind, degrees, yaw, friction, onMesh);
            BodyRun run = stage.start();
            Pose from = run.pose("thing");
            run.run(seconds);
            return new double[] {Rest.distance(from, run.pose("thing")),
                Math.toDegrees(Rest.angle(from, run.pose("thing"))),
                Rest.speed(run.velocities("thing"))};
        }
    }

    /** A body placed near its tipping angle stands 0.1 degrees below it, and falls over 0.1 degrees above. */
    static void tip(Kind kind, double yaw, boolean onMesh, Findings into) throws Exception {
        double limit = Math.toDegrees(Math.atan(kind.tips(yaw)));
        into.in(String.format(Locale.ROOT, "%s at %.1f degrees%s, tips over from %.2f degrees", kind, yaw, onMesh
            ? " on a mesh" : "", limit));
        into.atMost("0.1 degrees below turns by, degrees", STANDS, place(kind, limit - OFF, yaw, ROUGH, onMesh, 3)[1]);
        into.atLeast("0.1 degrees above turns by, degrees", TIPPED, place(kind, limit + OFF, yaw, ROUGH, onMesh, 3)[1]);
    }

    /** A body stays 0.1 degrees below the friction limit; above it slides as the closed form says. */
    static void slide(Kind kind, boolean onMesh, Findings into) throws Exception {
        double limit = Math.toDegrees(Math.atan(SMOOTH));
        into.in(kind + (onMesh ? " on a mesh" : "") + " slides");
        into.atMost("0.1 degrees below moves by, m", HOLDS, place(kind, limit - OFF, 10, SMOOTH, onMesh, 3)[0]);
        for (double above : new double[] {OFF, 6}) {
            double slope = Math.toRadians(limit + above);
            double a = G * (Math.sin(slope) - SMOOTH * Math.cos(slope));
            double[] result = place(kind, limit + above, 10, SMOOTH, onMesh, 1.5);
            into.within(above + " degrees above, speed, m/s", 1.5 * a, SHARE, result[2]);
            into.within(above + " degrees above, distance, m", 1.125 * a, SHARE, result[0]);
        }
    }

    /**
     * Pushes a standing body at its centre of mass, with a share of its weight that grows to a limit and stays there.
     */
    private static double[] push(Kind kind, double share, double azimuth, double friction) throws Exception {
        try (Stage stage = new Stage()) {
            put(stage, kind, 0, 0, friction, false);
            BodyRun run = stage.start();
            Pose from = run.pose("thing");
            push(run, "thing", share, Math.cos(azimuth), Math.sin(azimuth), 4);
            return new double[] {Rest.distance(from, run.pose("thing")),
                Math.toDegrees(Rest.angle(from, run.pose("thing")))};
        }
    }

    /** Pushes a body of 1 kg or a robot for some seconds; in the first two seconds the force grows. */
    private static void push(BodyRun run, String name, double share, double x, double z, double seconds) {
        double weight = run.body(name).mass * G;
        double start = run.time();
        while (run.time() - start < seconds) {
            double force = share * weight * Math.min(1, (run.time() - start) / 2);
            run.body(name).wake();
            run.body(name).pull(force * x, 0, force * z);
            run.step();
        }
    }

    /** A push at the centre of mass tips or moves a body within 1 % of the closed forms. */
    static void push(Kind kind, double azimuth, Findings into) throws Exception {
        double tips = kind.tips(azimuth);
        double angle = Math.toRadians(180 - azimuth);
        into.in(String.format(Locale.ROOT, "%s pushed towards %.1f degrees", kind, azimuth));
        into.atMost("1 % below its tipping force turns by, degrees", STANDS,
            push(kind, (1 - SHARE) * tips, angle, ROUGH)[1]);
        into.atLeast("1 % above turns by, degrees", TIPPED, push(kind, (1 + SHARE) * tips, angle, ROUGH)[1]);
        into.atMost("1 % below the friction limit moves by, m", HOLDS,
            push(kind, (1 - SHARE) * SMOOTH, angle, SMOOTH)[0]);
        into.atLeast("1 % above moves by, m", SLID, push(kind, (1 + SHARE) * SMOOTH, angle, SMOOTH)[0]);
    }

    /** A box that is pushed suddenly, 0.5 % above the friction limit, gets the speed that force less friction gives. */
    static void breakAway(Kind kind, Findings into) throws Exception {
        try (Stage stage = new Stage()) {
            put(stage, kind, 0, 10, SMOOTH, false);
            BodyRun run = stage.start();
            run.run(1);
            double a = 0.005 * SMOOTH * G;
            into.in(kind + " breaks away");
            for (int step = 1; step <= 60; step++) {
                run.body("thing").wake();
                run.body("thing").pull(SMOOTH * G + a, 0, 0);
                run.step();
                if (step == 1 || step == 60) {
                    into.within("speed after " + step + " steps, m/s", a * step / 60, SHARE,
                        Rest.speed(run.velocities("thing")));
                }
            }
        }
    }

    /** Makes a robot. */
    interface Maker {
        SEARrobot make(String name);
    }

    /**
     * A robot that is pushed slowly tips over within 1 % of the force that follows from its tipping angle and the lean
     * of its springs.
     * @param x direction of the push, likewise z
     * @param degrees of a slope on which it would tip over with stiff springs
     * @param shift by which its wheels' contact moves as it leans, per radian, over the height of its centre of mass
     */
    static void robot(Maker maker, String name, double x, double z, double degrees, double shift, Findings into)
        throws Exception {
        double lean = lean(maker, x, z, Math.tan(Math.toRadians(0.9 * degrees)), 6) / Math.tan(
            Math.toRadians(0.9 * degrees));
        double limit = degrees;
        for (int i = 0; i < 10; i++) {
            // leaning moves the centre of mass, and the contact of its round wheels
            limit = degrees - (1 - shift) * lean * Math.tan(Math.toRadians(limit))
                * Math.pow(Math.cos(Math.toRadians(limit)), 2);
        }
        into.in(String.format(Locale.ROOT, "%s, tips over from %.2f degrees, from %.2f with stiff springs", name,
            limit, degrees));
        double push = Math.tan(Math.toRadians(limit));
        into.atMost("1 % below its tipping force leans by, degrees", TIPPED, lean(maker, x, z, (1 - SHARE) * push, 6));
        into.atLeast("1 % above leans by, degrees", TIPPED, lean(maker, x, z, (1 + SHARE) * push, 6));
    }

    private static double lean(Maker maker, double x, double z, double share, double seconds) throws Exception {
        try (Stage stage = new Stage()) {
            new Floor("floor", 100, 100).setFriction(10);
            maker.make("robot");
            BodyRun run = stage.start();
            run.run(1);
            push(run, "robot", share, x, z, seconds);
            return Math.toDegrees(Math.acos(Math.min(1, run.pose("robot").rotate(0, 1, 0)[1])));
        }
    }

    /** A robot at rest holds a push of 1 % below the friction of its wheels, and slides from 1 % above. */
    static void slide(Maker maker, String name, double x, double z, Findings into) throws Exception {
        into.in(name + " slides");
        into.atMost("1 % below the friction limit moves by, m", SLID, slid(maker, x, z, (1 - SHARE) * SMOOTH));
        into.atLeast("1 % above moves by, m", 10 * SLID, slid(maker, x, z, (1 + SHARE) * SMOOTH));
    }

    private static double slid(Maker maker, double x, double z, double share) throws Exception {
        try (Stage stage = new Stage()) {
            new Floor("floor", 100, 100).setFriction(SMOOTH / WHEEL_FRICTION);
            maker.make("robot");
            BodyRun run = stage.start();
            run.run(1);
            Pose from = run.pose("robot");
            push(run, "robot", share, x, z, 4);
            return Rest.distance(from, run.pose("robot"));
        }
    }
}
