package org.SEAR.simulator;

import java.util.function.Consumer;
import org.SEAR.robot.DriveOrder;
import org.SEAR.robot.Robot;

/** A command that moves a robot, as {@link Simulation#post} takes it; a record knows it again. Immutable, any thread. */
public final class DriveCommand implements Consumer<Simulation> {
    /** Number of the robot in {@code Project.getRobots()}. */
    public final int robot;
    /** Whether {@link #first} and {@link #second} are the speeds of the left and right wheels, m/s; else speed and radius of a circle, m/s and m. */
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
     * What a script has ordered.
     *
     * @throws IllegalArgumentException if the robot can't do that, with what would let it
     */
    public static DriveCommand of(Simulation world, Robot driven, DriveOrder order) {
        return new DriveCommand(world.getRobots().indexOf(driven), order.wheels, order.getFirst(driven), order.getSecond());
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
