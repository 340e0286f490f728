package org.SEAR.simulator.orders;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.Body;

/** Gives bodies the velocities with which they start, and what they are told while the world runs. Simulation thread. */
public final class BodyOrders {
    private final Pushes pushes = new Pushes();
    private final Map<DragSpring, Body> hands = new LinkedHashMap<>();
    private final List<Body> launched = new ArrayList<>();
    private final List<Shape> shapes = new ArrayList<>();
    private final double[] v = new double[6];

    /** A thing of the environment, which may have a velocity at the start. */
    public void add(SearObject object, Body body) {
        if (((Shape) object).isLaunched() && !body.isFixed()) {
            launched.add(body);
            shapes.add((Shape) object);
        }
    }

    /** All bodies are at their start. */
    public void restart() {
        pushes.restart();
        for (int i = 0; i < launched.size(); i++) {
            double[] speed = shapes.get(i).getVelocity();
            double[] spin = shapes.get(i).getSpin();
            launched.get(i).setVelocities(speed[0], speed[1], speed[2], Math.toRadians(spin[0]), Math.toRadians(spin[1]), Math.toRadians(spin[2]));
        }
    }

    /**
     * Obeys an order.
     *
     * @param body of its name; null if there is none
     * @throws IllegalArgumentException if it can't be moved
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
            body.setVelocities(v[0], v[1], v[2], Math.toRadians(order.x), Math.toRadians(order.y), Math.toRadians(order.z));
        }
    }

    private static void check(String name, Body body) {
        if (body == null) {
            throw new IllegalArgumentException("nothing that can be moved is named \"" + name + "\", legal: a thing with a mass, or a robot");
        }
        if (body.isFixed()) {
            throw new IllegalArgumentException(name + " is fixed (mass 0) and can't be moved so, legal: a thing with a mass, or a robot");
        }
    }

    /**
     * Has a hand hold something from the next step on, until it lets go.
     *
     * @param body of its name; null if there is none
     * @throws IllegalArgumentException if it can't be moved
     */
    public void hold(DragSpring hand, Body body) {
        check(hand.getName(), body);
        hands.put(hand, body);
    }

    private static void checkStrength(BodyOrder order, Body body) {
        double force = Math.sqrt(order.x * order.x + order.y * order.y + order.z * order.z);
        double most = BodyOrder.FASTEST * body.mass / TimeStep.SECONDS;
        if (force > most) {
            throw new IllegalArgumentException(order.name + " is pushed with " + force + " N, legal for its " + body.mass + " kg: at most " + most
                + " N");
        }
    }

    /**
     * Before the physics of a step.
     *
     * @param reported hears what hands do in it
     */
    public void act(Consumer<BodyOrder> reported) {
        if (!hands.isEmpty()) {
            hands.entrySet().removeIf(held -> !pull(held.getKey(), held.getValue(), reported));
        }
        pushes.act();
    }

    /** @return false once it has let go */
    private boolean pull(DragSpring hand, Body body, Consumer<BodyOrder> reported) {
        BodyOrder order = hand.pull(body);
        if (order != null) {
            execute(order, body);
            reported.accept(order);
        }
        return order != null;
    }

    /** A body was put elsewhere, at rest. */
    public void forget(Body body) {
        pushes.forget(body);
        hands.values().removeIf(held -> held == body);
    }
}
