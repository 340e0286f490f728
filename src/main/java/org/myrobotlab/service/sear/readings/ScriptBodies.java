package org.myrobotlab.service.sear.readings;

import java.util.List;
import org.SEAR.POJOs.Workbench;
import org.SEAR.grammar.ScriptText;
import org.SEAR.simulator.orders.BodyOrder;
import org.myrobotlab.service.sear.run.SimulationControl;

/** Velocities and pushes of things and robots by call; each is obeyed between two steps, before the call returns. Any thread. */
public final class ScriptBodies implements Workbench.Acts {
    private final SimulationControl control;

    public ScriptBodies(SimulationControl control) {
        this.control = control;
    }

    /**
     * Pushes a thing or robot at its centre of mass, from the next step on.
     *
     * @param force N along the world's axes: three numbers
     * @param seconds simulated, above 0
     */
    public void push(String name, List<?> force, double seconds) throws InterruptedException {
        if (force == null || force.size() != 3 || !force.stream().allMatch(Number.class::isInstance)) {
            throw new IllegalArgumentException("push: force is " + force + ", legal: three numbers, [x, y, z] in N along the world's axes");
        }
        double[] n = force.stream().mapToDouble(one -> ((Number) one).doubleValue()).toArray();
        order(BodyOrder.Kind.PUSH, name, n[0], n[1], n[2], seconds);
    }

    /** @param x m/s along the world's x, likewise y and z */
    public void velocity(String name, double x, double y, double z) throws InterruptedException {
        order(BodyOrder.Kind.VELOCITY, name, x, y, z, 0);
    }

    /** @param x degrees a second about the world's x, likewise y and z */
    public void spin(String name, double x, double y, double z) throws InterruptedException {
        order(BodyOrder.Kind.SPIN, name, x, y, z, 0);
    }

    private void order(BodyOrder.Kind kind, String name, double x, double y, double z, double seconds) throws InterruptedException {
        if (name == null) {
            throw new IllegalArgumentException("the name is missing (None), legal: the name of a thing with a mass, or of a robot");
        }
        BodyOrder order = new BodyOrder(kind, ScriptText.of(name), x, y, z, seconds);
        control.session().ask(world -> {
            world.order(order);
            return true;
        });
    }

    @Override
    public void setVelocity(String name, double x, double y, double z) {
        forObject(() -> velocity(name, x, y, z));
    }

    @Override
    public void setSpin(String name, double x, double y, double z) {
        forObject(() -> spin(name, x, y, z));
    }

    /** Something that waits for the simulation. */
    private interface Call {
        void run() throws InterruptedException;
    }

    private static void forObject(Call call) {
        try {
            call.run();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("the script was stopped while it waited", e);
        }
    }
}
