package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Sphere;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** What spins goes on spinning, however fast. */
public class SpinTest {
    private static final double G = 9.81;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static Body body(Simulation simulation, String name) {
        return simulation.getWorld().getPhysics().getBodies().stream().filter(body -> body.name.equals(name)).findFirst().get();
    }

    /** A ball of 0.1 m comes to 175 rad/s in 5 s. */
    @Test
    public void whatRollsDownASlopeRollsAsFastAsTheClosedFormSays() throws Exception {
        double slope = Math.toRadians(30);
        new Floor("slope", 400, 10).rotate(0, 0, 30);
        roll(new Sphere("ball", 0.1, 2), 0, slope);
        SearObject wheel = new Cylinder("wheel", 0.1, 0.3, 2);
        roll(wheel, 2, slope);
        wheel.rotate(90, 0, 0);
        Simulation simulation = Worlds.start(project);
        double x = simulation.getPose("ball").x;
        Worlds.run(simulation, 5);
        double pull = G * (Math.sin(slope) - 0.002 * Math.cos(slope)) * 12.5;
        assertEquals(pull * 5 / 7, (x - simulation.getPose("ball").x) / Math.cos(slope), pull * 5 / 7 * 5e-3);
        assertEquals(pull * 2 / 3, (x - simulation.getPose("wheel").x) / Math.cos(slope), pull * 2 / 3 * 5e-3);
        double[] spin = new double[3];
        body(simulation, "ball").angularVelocity(spin);
        assertEquals(pull * 5 / 7 * 2 / 5 / 0.1, Math.sqrt(spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2]), 1);
    }

    private static void roll(SearObject thing, double z, double slope) {
        thing.move(-0.1 * Math.sin(slope), 0.1 * Math.cos(slope), z);
    }

    /** Turned about its middle axis, a box turns over again and again (Dzhanibekov), and loses neither energy nor momentum. */
    @Test
    public void aBoxThatTumblesKeepsEnergyAndMomentum() throws Exception {
        new Box("box", 0.1, 0.4, 0.2, 1).move(0, 1000, 0);
        Simulation simulation = Worlds.start(project);
        Body box = body(simulation, "box");
        double[] moments = {(0.04 + 0.16) / 12, (0.01 + 0.16) / 12, (0.01 + 0.04) / 12};
        double[] spin = new double[3];
        simulation.step();
        turn(box, simulation.getPose("box"), new double[] {1e-4, moments[1] * 20, 0});
        double energy = 0;
        double[] momentum = new double[3];
        double least = 1;
        for (int step = 0; step < 600; step++) {
            Pose pose = simulation.getPose("box");
            box.angularVelocity(spin);
            double[] own = pose.rotateBack(spin[0], spin[1], spin[2]);
            double now = 0;
            for (int i = 0; i < 3; i++) {
                now += moments[i] * own[i] * own[i] / 2;
                own[i] *= moments[i];
            }
            double[] whole = pose.rotate(own[0], own[1], own[2]);
            if (step == 0) {
                energy = now;
                momentum = whole;
            }
            assertEquals("energy in step " + step, energy, now, energy * 0.01);
            double size = Math.sqrt(momentum[0] * momentum[0] + momentum[1] * momentum[1] + momentum[2] * momentum[2]);
            for (int i = 0; i < 3; i++) {
                assertEquals("momentum in step " + step, momentum[i], whole[i], size * 0.01);
            }
            least = Math.min(least, own[1] / size);
            simulation.step();
        }
        assertEquals("it has turned over", -1, least, 0.05);
    }

    /** By two pushes that move it nowhere. */
    private static void turn(Body body, Pose at, double[] momentum) {
        body.push(new double[] {momentum[1] / 2, 0, 0}, new double[] {at.x, at.y, at.z + 1});
        body.push(new double[] {-momentum[1] / 2, 0, 0}, new double[] {at.x, at.y, at.z - 1});
        body.push(new double[] {0, 0, momentum[0] / 2}, new double[] {at.x, at.y + 1, at.z});
        body.push(new double[] {0, 0, -momentum[0] / 2}, new double[] {at.x, at.y - 1, at.z});
    }
}
