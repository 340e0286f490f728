// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.function.Consumer;
import org.SEAR.robot.DriveOrder;
import org.SEAR.robot.Robot;

/** A command that moves a robot, for {@link Simulation#post}. Records store it. Immutable, any thread. */
public final class DriveCommand implements Consumer<Simulation> {
    /** Index of the robot in {@code Project.getRobots()}. */
    public final int robot;
    /**
     * True: {@link #first} and {@link #second} are the speeds of the left and right wheels, m/s. False: they are the
     * speed, m/s, and the radius of a circle, m.
     */
    public final boolean wheels;
    public final double first;
    public final double second;

    private DriveCommand(int robot, boolean wheels, double first, double second) {
        this.robot = robot;
        this.wheels = wheels;
        this.first = first;
        this.second = second;
    }

    /** @param left m/s over ground, + forward, likewise right */
    public static DriveCommand wheels(int robot, double left, double right) {
        return new DriveCommand(robot, true, left, right);
    }

    /** @param radius metres, + to the left, infinite = straight, 0 = in place */
    public static DriveCommand circle(int robot, double speed, double radius) {
        return new DriveCommand(robot, false, speed, radius);
    }

    /**
     * Converts a script's order into a command.
     *
     * @throws IllegalArgumentException if the robot can't do that; the message says what would let it
     */
    public static DriveCommand of(Simulation world, Robot driven, DriveOrder order) {
        return new DriveCommand(world.getRobots().indexOf(driven), order.wheels, order.getFirst(driven),
            order.getSecond());
    }

    @Override
    public void accept(Simulation simulation) {
        Robot driven = simulation.getRobots().get(robot);
        if (wheels) {
            driven.getHardware().setWheelSpeeds(first, second);
        } else {
            driven.drive(first, second);
        }
    }
}
