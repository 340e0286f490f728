// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.readings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.SEAR.POJOs.ScriptSession;
import org.SEAR.grammar.ScriptText;
import org.SEAR.physics.solid.MassProperties;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.orders.BodyOrder;
import org.SEAR.simulator.orders.DragSpring;
import org.myrobotlab.service.sear.run.SimulationControl;
import org.myrobotlab.service.sear.run.SimulationSession;

/**
 * Velocities of and forces on objects and robots, and gravity, by call. Each takes effect between two steps, before the
 * call returns. Any thread.
 */
public final class ScriptBodies implements ScriptSession.Acts {
    private final SimulationControl control;
    /** Drag springs by the name of the object that they hold. */
    private final Map<String, DragSpring> hands = new ConcurrentHashMap<>();
    /** The simulation with these springs. Guarded by this. */
    private SimulationSession holder;

    public ScriptBodies(SimulationControl control) {
        this.control = control;
    }

    /**
     * Applies a force at the centre of mass of an object or robot, from the next step on.
     *
     * @param force N along the world's axes: three numbers
     * @param seconds simulated duration, above 0
     */
    public void push(String name, List<?> force, double seconds) throws InterruptedException {
        double[] n = numbers("push: force", force, "N");
        order(BodyOrder.Kind.PUSH, name, n[0], n[1], n[2], seconds);
    }

    private static double[] numbers(String what, List<?> list, String unit) {
        if (list == null || list.size() != 3 || !list.stream().allMatch(Number.class::isInstance)) {
            throw new IllegalArgumentException(what + " is " + list + ", legal: three numbers, [x, y, z] in " + unit
                + " along the world's axes");
        }
        return list.stream().mapToDouble(one -> ((Number) one).doubleValue()).toArray();
    }

    /**
     * Pulls an object or robot by a drag spring. The spring releases it 1.5 s after the last call, in lock-step 1.5
     * simulated seconds, or on {@link #letGo}.
     *
     * @param way target, metres from its position at the first call: three numbers
     */
    public synchronized void hold(String name, List<?> way) throws InterruptedException {
        double[] to = numbers("hold: way", way, "metres");
        if (!Double.isFinite(to[0] + to[1] + to[2])) {
            throw new IllegalArgumentException("hold: way is " + way + ", legal: three finite numbers");
        }
        String held = ScriptText.of(name);
        SimulationSession session = control.session();
        if (session != holder) {
            holder = session;
            hands.clear();
        }
        DragSpring hand = hands.get(held);
        if (hand != null && hand.isHolding()) {
            hand.moveTo(to[0], to[1], to[2]);
        } else {
            DragSpring fresh = new DragSpring(held, session::isLockStep, System::nanoTime);
            fresh.moveTo(to[0], to[1], to[2]);
            session.ask(world -> {
                world.hold(fresh, held);
                return true;
            });
            hands.put(held, fresh);
        }
    }

    /** Releases an object or robot. */
    public void letGo(String name) {
        DragSpring hand = hands.remove(ScriptText.of(name));
        if (hand != null) {
            hand.letGo();
        }
    }

    /**
     * Returns the mass properties of an object or robot in its own frame: "mass" in kg, "centre" [x, y, z] in metres,
     * and "tensor", the rows of the inertia tensor about the centre of mass in kg m^2.
     */
    public Map<String, Object> massProperties(String name) throws InterruptedException {
        String asked = given(name);
        MassProperties properties = control.session().ask(world -> world.getMassProperties(asked));
        Map<String, Object> answer = new LinkedHashMap<>();
        answer.put("mass", properties.mass);
        answer.put("centre", list(properties.centre()));
        List<List<Double>> rows = new ArrayList<>();
        for (double[] row : properties.inertia.toRows()) {
            rows.add(list(row));
        }
        answer.put("tensor", rows);
        return answer;
    }

    private static List<Double> list(double[] numbers) {
        List<Double> list = new ArrayList<>();
        for (double number : numbers) {
            list.add(number + 0.0);    // 0 instead of -0
        }
        return list;
    }

    /** @param x m/s along the world's x, likewise y and z */
    public void velocity(String name, double x, double y, double z) throws InterruptedException {
        order(BodyOrder.Kind.VELOCITY, name, x, y, z, 0);
    }

    /** @param x degrees per second about the world's x, likewise y and z */
    public void spin(String name, double x, double y, double z) throws InterruptedException {
        order(BodyOrder.Kind.SPIN, name, x, y, z, 0);
    }

    /** @param acceleration of gravity, m/s^2 downwards */
    public void gravity(double acceleration) throws InterruptedException {
        order(BodyOrder.gravity(acceleration));
    }

    /** Returns present gravity, m/s^2 downwards. */
    public double gravity() throws InterruptedException {
        return control.session().ask(Simulation::getGravity);
    }

    private void order(BodyOrder.Kind kind, String name, double x, double y, double z, double seconds)
        throws InterruptedException {
        order(new BodyOrder(kind, given(name), x, y, z, seconds));
    }

    private void order(BodyOrder order) throws InterruptedException {
        control.session().ask(world -> {
            world.order(order);
            return true;
        });
    }

    private static String given(String name) {
        if (name == null) {
            throw new IllegalArgumentException(
                "the name is missing (None), legal: the name of an object with a mass, or of a robot");
        }
        return ScriptText.of(name);
    }

    @Override
    public void setVelocity(String name, double x, double y, double z) {
        forObject(() -> velocity(name, x, y, z));
    }

    @Override
    public void setSpin(String name, double x, double y, double z) {
        forObject(() -> spin(name, x, y, z));
    }

    @Override
    public void setGravity(double acceleration) {
        forObject(() -> gravity(acceleration));
    }

    /** An action that waits for the simulation. */
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
