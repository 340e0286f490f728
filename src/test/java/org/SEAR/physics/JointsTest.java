// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.BallJoint;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.FixedJoint;
import org.SEAR.POJOs.Gravity;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Rope;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Slider;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.ActuatorOrder.Kind;
import org.SEAR.simulator.BodyRun;
import org.junit.Test;

/** Joints against closed forms: pendulums, linkages, springs, motors, limits. */
public class JointsTest {
    private static final double G = Gravity.EARTH;
    private static final double STEP = 1 / 60.0;

    /** Returns a bar of square section from one point to another in the plane z = 0. */
    private static Box bar(String name, double mass, double x1, double y1, double x2, double y2) {
        double length = Math.hypot(x2 - x1, y2 - y1);
        return new Box(name, length, 0.02, 0.02, mass, (x1 + x2) / 2, (y1 + y2) / 2, 0, 0, 0,
            Math.toDegrees(Math.atan2(y2 - y1, x2 - x1)));
    }

    /** A hinge that turns about z. */
    private static Hinge hinge(String name, Shape first, Shape second, double x, double y) {
        return new Hinge(name, first, second, x, y, 0, 90, 0, 0);
    }

    private static double energy(BodyRun run, String... names) {
        double sum = 0;
        for (String name : names) {
            Body body = run.body(name);
            double[] v = run.velocities(name);
            double[] turning = body.getPose().rotateBack(v[3], v[4], v[5]);
            sum += body.mass * (G * body.getPose().y + (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 2)
                + (body.getMassProperties().inertia.xx * turning[0] * turning[0] + body.getMassProperties().inertia.yy
                    * turning[1] * turning[1]
                    + body.getMassProperties().inertia.zz * turning[2] * turning[2]) / 2;
        }
        return sum;
    }

    @Test
    public void pendulumsHaveTheirPeriod() throws Exception {
        for (double degrees : new double[] {5, 60, 150}) {
            assertEquals(degrees + " degrees", exactPeriod(degrees), period(degrees), 1e-3 * exactPeriod(degrees));
        }
    }

    /** Period of a uniform rod of 1 m with a section of 2 cm, by the arithmetic-geometric mean. */
    private static double exactPeriod(double degrees) {
        double inertia = (1 + 0.02 * 0.02) / 12 + 0.25;
        double a = 1;
        double b = Math.cos(Math.toRadians(degrees) / 2);
        for (int i = 0; i < 10; i++) {
            double mean = (a + b) / 2;
            b = Math.sqrt(a * b);
            a = mean;
        }
        return 2 * Math.PI / Math.sqrt(G / 2 / inertia) / a;
    }

    private static double period(double degrees) throws Exception {
        try (Stage stage = new Stage()) {
            double angle = Math.toRadians(degrees);
            hinge("pivot", null, bar("rod", 1, 0, 2, Math.sin(angle), 2 - Math.cos(angle)), 0, 2);
            BodyRun run = stage.start();
            List<Double> crossings = new ArrayList<>();
            double last = run.pose("rod").x;
            while (crossings.size() < 6) {
                run.step();
                double x = run.pose("rod").x;
                if (last < 0 && x >= 0) {
                    crossings.add(run.time() - STEP * x / (x - last));
                }
                last = x;
            }
            return (crossings.get(5) - crossings.get(0)) / 5;
        }
    }

    private static void step(BodyRun run, int count) {
        for (int i = 0; i < count; i++) {
            run.step();
        }
    }

    /** Path of MuJoCo 4.0, Runge-Kutta at 0.1 ms: scripts/benchmark --joints=chain-5. */
    @Test
    public void aChainFallsAsInMuJoCo() throws Exception {
        try (Stage stage = new Stage()) {
            Box link = null;
            for (int i = 0; i < 5; i++) {
                Box next = new Box("link" + i, 0.1, 0.01, 0.01, 0.1, 0.1 * i + 0.05, 3, 0);
                hinge("hinge" + i, link, next, 0.1 * i, 3).setDamping(0.001);
                link = next;
            }
            BodyRun run = stage.start();
            step(run, 30);
            assertEquals(-0.393601, run.pose("link4").x, 4e-4);
            assertEquals(2.782333, run.pose("link4").y, 4e-4);
            step(run, 30);
            assertEquals(0.020233, run.pose("link4").x, 4e-4);
            assertEquals(2.567530, run.pose("link4").y, 4e-4);
        }
    }

    @Test
    public void aDoublePendulumKeepsItsEnergy() throws Exception {
        try (Stage stage = new Stage()) {
            Box upper = bar("upper", 1, 0, 2, 1, 2);
            Box lower = bar("lower", 1, 1, 2, 2, 2);
            hinge("shoulder", null, upper, 0, 2);
            hinge("elbow", upper, lower, 1, 2);
            BodyRun run = stage.start();
            double before = energy(run, "upper", "lower");
            double most = 0;
            for (int i = 0; i < 600; i++) {
                run.step();
                most = Math.max(most, Math.abs(energy(run, "upper", "lower") - before));
            }
            assertEquals("of 39 J between top and bottom", 0, most, 0.2);
            assertEquals(0, run.pose("lower").z, 1e-9);
        }
    }

    @Test
    public void aFourBarLinkageStaysClosed() throws Exception {
        try (Stage stage = new Stage()) {
            double x = knee()[0];
            double y = knee()[1];
            Box crank = bar("crank", 0.2, 0, 0, 0, 0.1);
            Box coupler = bar("coupler", 0.4, 0, 0.1, x, y);
            Box rocker = bar("rocker", 0.4, 0.3, 0, x, y);
            hinge("drive", null, crank, 0, 0).setMotor(5, 1000);
            hinge("a", crank, coupler, 0, 0.1);
            hinge("b", coupler, rocker, x, y);
            hinge("c", null, rocker, 0.3, 0);
            BodyRun run = stage.start();
            run.order(Kind.JOINT_SPEED, "drive", 360);
            double open = 0;
            for (int i = 0; i < 300; i++) {
                run.step();
                double[] ofCoupler = run.pose("coupler").transform(0.15, 0, 0);
                double[] ofRocker = run.pose("rocker").transform(0.125, 0, 0);
                open = Math.max(open, Math.hypot(ofCoupler[0] - ofRocker[0], ofCoupler[1] - ofRocker[1]));
            }
            assertEquals(0, open, 1e-4);
            assertEquals(5 * 360, run.joint("drive")[0], 5);
        }
    }

    /** Where a coupler of 0.3 m from (0, 0.1) meets a rocker of 0.25 m from (0.3, 0). */
    private static double[] knee() {
        double apart = Math.hypot(0.3, 0.1);
        double along = (0.09 - 0.0625 + apart * apart) / 2 / apart;
        double off = Math.sqrt(0.09 - along * along);
        return new double[] {(0.3 * along + 0.1 * off) / apart, 0.1 + (-0.1 * along + 0.3 * off) / apart};
    }

    @Test
    public void aChainCarriesAHundredTimesItsWeight() throws Exception {
        try (Stage stage = new Stage()) {
            Shape above = null;
            for (int i = 0; i < 20; i++) {
                Box link = bar("link" + i, 0.1, 0, 5 - 0.1 * i, 0, 4.9 - 0.1 * i);
                new BallJoint("joint" + i, above, link, 0, 5 - 0.1 * i, 0);
                above = link;
            }
            Box load = new Box("load", 0.2, 0.2, 0.2, 10, 0, 2.9, 0);
            new BallJoint("hook", above, load, 0, 3, 0);
            BodyRun run = stage.start();
            run.run(2);
            assertEquals(2.9, run.pose("load").y, 1e-6);
            assertFalse("asleep", run.body("load").isActive());
            assertEquals(12 * G, run.jointForce("joint0")[1], 0.01 * G);
        }
    }

    @Test
    public void aMotorHoldsUpToItsForceAndSinksBeyond() throws Exception {
        double[] held = loadedLift(9);
        assertEquals("a tenth below full power", -0.0009, held[0], 1e-5);
        assertEquals(9, held[2], 0.01);
        double[] sinking = loadedLift(11);
        assertEquals("speed = 1 m/s (1 - 11 N / 10 N)", -0.1, sinking[1], 1e-3);
        assertEquals(11, sinking[2], 0.02);
    }

    /** Returns the reading of a lift of 10 N and 1 m/s after two seconds under a load. */
    private static double[] loadedLift(double newtons) throws Exception {
        try (Stage stage = new Stage()) {
            Box load = new Box("load", 0.1, 0.1, 0.1, newtons / G, 0, 5, 0);
            new Slider("lift", null, load, 0, 5, 0).setMotor(10, 1);
            BodyRun run = stage.start();
            run.run(2);
            return run.joint("lift");
        }
    }

    @Test
    public void aCraneTipsAsStaticsSays() throws Exception {
        assertTrue("10 kg times 0.2 m beside 2.45 kg times 0.8 m", craneTilt(2.45) < 0.1);
        assertTrue(craneTilt(2.55) > 5);
    }

    private static double craneTilt(double load) throws Exception {
        try (Stage stage = new Stage(10)) {
            Box base = new Box("base", 0.4, 0.1, 0.4, 10, 0, 0.05, 0);
            Box arm = new Box("arm", 0.1, 0.1, 0.1, load, 1, 0.5, 0);
            new Hinge("mast", base, arm, 0, 0.5, 0);
            BodyRun run = stage.start();
            run.run(3);
            double[] up = run.pose("base").rotate(0, 1, 0);
            return Math.toDegrees(Math.acos(Math.min(1, up[1])));
        }
    }

    @Test
    public void aFlywheelTurnsItsBaseBack() throws Exception {
        try (Stage stage = new Stage()) {
            Box base = new Box("base", 0.4, 0.4, 0.1, 2, 0, 500, 0);
            Box wheel = new Box("wheel", 0.3, 0.3, 0.05, 1, 0, 500.1, 0);
            new Hinge("axle", base, wheel, 0, 500.1, 0).setMotor(1, 6000);
            BodyRun run = stage.start();
            run.order(Kind.JOINT_POWER, "axle", 0.5);
            run.run(1);
            double ofBase = 2 * (0.16 + 0.16) / 12 * run.velocities("base")[4];
            double ofWheel = (0.09 + 0.09) / 12 * run.velocities("wheel")[4];
            assertTrue("it turns", ofWheel > 0.1);
            assertEquals(0, ofBase + ofWheel, 1e-6);
        }
    }

    @Test
    public void gearsHoldTheirRatioUnderLoad() throws Exception {
        try (Stage stage = new Stage()) {
            Box wheel = new Box("wheel", 0.2, 0.2, 0.05, 1, 0, 5, 0);
            Hinge driving = hinge("driving", null, wheel, 0, 5);
            driving.setMotor(5, 720);
            Box pinion = new Box("pinion", 0.1, 0.1, 0.05, 0.3, 1, 5, 0);
            Hinge meshing = hinge("meshing", null, pinion, 1, 5);
            meshing.setGear(driving, -2.5);
            Box rack = new Box("rack", 0.1, 0.1, 0.1, 2, 2, 5, 0);
            new Slider("lift", null, rack, 2, 5, 0).setGear(meshing, 0.001);
            BodyRun run = stage.start();
            run.order(Kind.JOINT_SPEED, "driving", -180);
            for (int i = 0; i < 300; i++) {
                run.step();
                double turned = run.joint("driving")[0];
                assertEquals(-2.5 * turned, run.joint("meshing")[0], 1e-5 * Math.abs(turned) + 1e-6);
                assertEquals(-0.0025 * turned, run.joint("lift")[0], 1e-8 * Math.abs(turned) + 1e-9);
            }
            assertEquals("the load of the rack at the motor, N m", 2 * G * 0.0025 * Math.toDegrees(1),
                -run.joint("driving")[2], 0.01);
            assertEquals("power = weight times speed", 0.45, run.joint("lift")[1], 1e-3);
        }
    }

    @Test
    public void aGearOfFreeBodiesReactsOnTheirFrame() throws Exception {
        try (Stage stage = new Stage()) {
            Box frame = new Box("frame", 0.4, 0.4, 0.1, 2, 0, 500, 0);
            Box big = new Box("big", 0.3, 0.3, 0.05, 1, 0, 500, 0);
            Box small = new Box("small", 0.1, 0.1, 0.05, 0.5, 0.4, 500, 0);
            Hinge axle = new Hinge("axle", frame, big, 0, 500, 0);
            axle.setMotor(1, 6000);
            Hinge other = new Hinge("other", frame, small, 0.4, 500, 0);
            other.setGear(axle, 3);
            BodyRun run = stage.start();
            run.order(Kind.JOINT_POWER, "axle", 0.5);
            run.run(1);
            assertTrue("it turns", run.joint("axle")[0] > 90);
            assertEquals(3 * run.joint("axle")[0], run.joint("other")[0], 1e-3);
            double sum = 0;
            for (String name : new String[] {"frame", "big", "small"}) {
                double[] v = run.velocities(name);
                Body body = run.body(name);
                sum += body.getMassProperties().inertia.yy * v[4]
                    + body.mass * (body.getPose().z * v[0] - body.getPose().x * v[2]);
            }
            assertEquals("angular momentum", 0, sum, 1e-5);
        }
    }

    @Test
    public void aSpringHasItsPeriodAndARopeItsLength() throws Exception {
        try (Stage stage = new Stage()) {
            Box weight = new Box("weight", 0.1, 0.1, 0.1, 1, 0, 5, 0);
            new Slider("spring", null, weight, 0, 5, 0).setSpring(100, 0);
            Box bob = new Box("bob", 0.1, 0.1, 0.1, 1, 3, 5, 0);
            new Rope("rope", null, bob, 2, 5, 0, 3, 5, 0);
            BodyRun run = stage.start();
            double lowest = 0;
            double longest = 0;
            List<Double> crossings = new ArrayList<>();
            double last = 1;
            for (int i = 0; i < 600; i++) {
                run.step();
                double x = run.joint("spring")[0] + G / 100;
                if (last < 0 && x >= 0) {
                    crossings.add(run.time() - STEP * x / (x - last));
                }
                last = x;
                lowest = Math.min(lowest, run.joint("spring")[0]);
                longest = Math.max(longest, Math.hypot(run.pose("bob").x - 2, run.pose("bob").y - 5));
            }
            int periods = crossings.size() - 1;
            assertEquals(2 * Math.PI / 10, (crossings.get(periods) - crossings.get(0)) / periods, 1e-3 * 0.628);
            assertEquals(-2 * G / 100, lowest, 1e-3);
            assertEquals(1, longest, 1e-5);
        }
    }

    @Test
    public void aDoorStopsAtItsLimitAndFrictionHoldsIt() throws Exception {
        try (Stage stage = new Stage()) {
            Box door = new Box("door", 0.8, 0.04, 2, 20, 0.4, 1, 0);
            Hinge hinge = new Hinge("hinge", null, door, 0, 1, 0);
            hinge.setLimits(-90, 90);
            hinge.setFriction(1);
            BodyRun run = stage.start();
            run.set("door", 0, 0, -0.8, 0, 2, 0);
            double most = 0;
            for (int i = 0; i < 240; i++) {
                run.step();
                most = Math.max(most, run.joint("hinge")[0]);
            }
            assertEquals("I omega^2 / 2 over 1 N m", Math.toDegrees(20 * (0.64 / 3 + 0.0016 / 12) * 4 / 2), 487, 5);
            assertEquals(90, most, 0.01);
            assertEquals("it stays", 90, run.joint("hinge")[0], 0.01);
            assertFalse("asleep", run.body("door").isActive());
        }
    }

    @Test
    public void aJointBreaksAtItsForce() throws Exception {
        try (Stage stage = new Stage()) {
            Box light = new Box("light", 0.1, 0.1, 0.1, 1, 0, 5, 0);
            Box heavy = new Box("heavy", 0.1, 0.1, 0.1, 3, 2, 5, 0);
            new FixedJoint("holds", null, light, 0, 5, 0).setBreakingForce(20);
            new FixedJoint("breaks", null, heavy, 2, 5, 0).setBreakingForce(20);
            BodyRun run = stage.start();
            run.run(0.5);
            assertEquals(5, run.pose("light").y, 1e-6);
            assertTrue("it fell", run.pose("heavy").y < 4);
            assertTrue(run.warnings(), run.warnings()
                .contains("FixedJoint \"breaks\" broke: its force was above its breakingForce, 20 N"));
            assertFalse(run.warnings(), run.warnings().contains("\"holds\""));
        }
    }

    @Test
    public void brokenHalvesCollideAgain() throws Exception {
        try (Stage stage = new Stage(10)) {
            Box low = new Box("low", 0.2, 0.2, 0.2, 1, 0, 0.1, 0);
            Box high = new Box("high", 0.2, 0.2, 0.2, 1, 0, 0.31, 0);
            new FixedJoint("weld", low, high, 0, 0.2, 0).setBreakingForce(5);
            BodyRun run = stage.start();
            run.run(2);
            assertTrue(run.warnings(), run.warnings().contains("\"weld\" broke"));
            assertEquals("it lies on the other one", 0.3, run.pose("high").y, 0.002);
        }
    }

    @Test
    public void aMotorWakesTheObjectThatCanMove() throws Exception {
        try (Stage stage = new Stage()) {
            Box frame = new Box("frame", 0.1, 0.1, 0.1);
            frame.move(0, 1, 0);
            Box door = new Box("door", 0.8, 0.04, 2, 20, 0.5, 1, 0);
            new Hinge("hinge", door, frame, 0, 1, 0).setMotor(50, 90);
            BodyRun run = stage.start();
            run.run(3);
            assertFalse(run.body("door").isActive());
            assertEquals("asleep", 0, run.joint("hinge")[1], 0);
            run.order(Kind.JOINT_POSITION, "hinge", 45);
            run.run(3);
            assertEquals(45, run.joint("hinge")[0], 0.1);
        }
    }

    @Test
    public void aRopeHangsFromWhereItIsTied() throws Exception {
        try (Stage stage = new Stage(10)) {
            Box weight = new Box("weight", 0.2, 0.2, 0.2, 1);
            weight.placeAt(0, 0);
            new Rope("rope", null, weight, 0, 2, 0, 0, 0.1, 0).setLimits(1.5, 1.8);
            BodyRun run = stage.start();
            assertEquals("its lower end is lifted by 0.1 m with the weight, its upper end is not", 1.8,
                run.joint("rope")[0], 1e-3);
        }
    }

    @Test
    public void tooManyJointsOfOneObjectAreRefused() throws Exception {
        try (Stage stage = new Stage()) {
            Box hub = new Box("hub", 1, 1, 1, 5, 0, 5, 0);
            for (int i = 0; i < 150; i++) {
                new BallJoint("joint" + i, null, hub, 0, 5, 0);
            }
            String said = assertThrows(ProjectException.class, stage::start).getMessage();
            assertTrue(said, said.contains("11175 pairs of joints act on a common object")
                && said.contains("at most 10000"));
        }
    }
}
