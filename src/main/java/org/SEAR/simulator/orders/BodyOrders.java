// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.orders;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.Body;
import org.SEAR.physics.RobotBodies;

/** Gives bodies their start velocities, and runs commands on bodies during the run. Simulation thread. */
public final class BodyOrders {
    private final Pushes pushes = new Pushes();
    private final Map<DragSpring, Body> hands = new LinkedHashMap<>();
    private final List<Body> launched = new ArrayList<>();
    private final List<Shape> shapes = new ArrayList<>();
    private final double[] v = new double[6];

    /** Adds an environment object, which may have a start velocity. */
    public void add(SearObject object, Body body) {
        if (((Shape) object).isLaunched() && !body.isFixed()) {
            launched.add(body);
            shapes.add((Shape) object);
        }
    }

    /** Sets the start velocities; all bodies are at their start. */
    public void restart() {
        pushes.restart();
        release(held -> true);
        for (int i = 0; i < launched.size(); i++) {
            double[] speed = shapes.get(i).getVelocity();
            double[] spin = shapes.get(i).getSpin();
            launched.get(i).setVelocities(speed[0], speed[1], speed[2], Math.toRadians(spin[0]),
                Math.toRadians(spin[1]), Math.toRadians(spin[2]));
        }
    }

    /**
     * Runs a command.
     *
     * @param body with the command's name; null if there is none
     * @throws IllegalArgumentException if the body can't be moved or the force is too strong
     */
    public void execute(BodyOrder order, Body body) {
        check(order.name, body);
        if (order.kind == BodyOrder.Kind.PUSH) {
            checkStrength(order, body);
            pushes.add(body, order);
            return;
        }
        body.velocities(v);
        if (order.kind == BodyOrder.Kind.VELOCITY) {
            body.setVelocities(order.x, order.y, order.z, v[3], v[4], v[5]);
        } else {
            body.setVelocities(v[0], v[1], v[2], Math.toRadians(order.x), Math.toRadians(order.y),
                Math.toRadians(order.z));
        }
    }

    private static void check(String name, Body body) {
        if (body == null) {
            throw new IllegalArgumentException("nothing that can be moved is named \"" + name
                + "\", legal: an object with a mass, or a robot");
        }
        if (body.isFixed()) {
            throw new IllegalArgumentException(name + " is fixed (mass 0) and can't be moved, legal: an object with a "
                + "mass, or a robot");
        }
    }

    /**
     * Lets a drag spring pull a body from the next step until its release.
     *
     * @param body with the spring's name; null if there is none
     * @throws IllegalArgumentException if the body can't be moved
     */
    public void hold(DragSpring hand, Body body) {
        check(hand.getName(), body);
        hands.put(hand, body);
    }

    private void release(Predicate<Body> which) {
        hands.forEach((hand, body) -> {
            if (which.test(body)) {
                hand.letGo();
            }
        });
        hands.values().removeIf(which);
    }

    private static void checkStrength(BodyOrder order, Body body) {
        double force = Math.sqrt(order.x * order.x + order.y * order.y + order.z * order.z);
        double most = BodyOrder.FASTEST * RobotBodies.whole(body).mass / TimeStep.SECONDS;
        if (force > most) {
            throw new IllegalArgumentException(order.name + " is pushed with " + force + " N, legal for its "
                + RobotBodies.whole(body).mass + " kg: at most " + most
                + " N");
        }
    }

    /**
     * Applies forces before the physics of a step.
     *
     * @param reported receives the forces of drag springs
     */
    public void act(Consumer<BodyOrder> reported) {
        if (!hands.isEmpty()) {
            hands.entrySet().removeIf(held -> !pull(held.getKey(), held.getValue(), reported));
        }
        pushes.act();
    }

    /** @return false after its release */
    private boolean pull(DragSpring hand, Body body, Consumer<BodyOrder> reported) {
        BodyOrder order = hand.pull(body);
        if (order != null) {
            execute(order, body);
            reported.accept(order);
        }
        return order != null;
    }

    /** Ends all forces on a teleported body. */
    public void forget(Body body) {
        pushes.forget(body);
        release(held -> held == body);
    }
}
