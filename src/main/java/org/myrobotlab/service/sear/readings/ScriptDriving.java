package org.myrobotlab.service.sear.readings;

import java.util.Arrays;
import java.util.function.BiFunction;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.DriveCommand;
import org.myrobotlab.service.sear.run.SimulationControl;

/**
 * Driving by call. A command goes straight to the wheels' motors, at the start of the next step, and holds until the next one, by call or through the
 * robot's port. A robot is meant by its name, the first by null. Any thread.
 */
public final class ScriptDriving {
    /** Fastest that wheels may be told to go over ground, m/s. */
    private static final double MOST_SPEED = 100;
    /** Fastest that a robot may be told to turn, degrees a second. */
    private static final double MOST_SPIN = 3600;

    private static final String SPIN = "spin";

    private final SimulationControl control;

    /** What a script has called. */
    private static final class Call {
        final String name;
        final String values;
        final boolean moves;

        Call(String name, boolean moves, double... values) {
            this.name = name;
            this.values = Arrays.toString(values);
            this.moves = moves;
        }
    }

    public ScriptDriving(SimulationControl control) {
        this.control = control;
    }

    /** @param speed m/s, + forward */
    public void straight(String robot, double speed) throws InterruptedException {
        check("driveStraight: speed", speed, MOST_SPEED, "m/s");
        give(robot, new Call("driveStraight", speed != 0, speed), (number, driven) -> DriveCommand.wheels(number, speed, speed));
    }

    /** @param degrees a second, + to the left */
    public void spin(String robot, double degrees) throws InterruptedException {
        check("spin: speed", degrees, MOST_SPIN, "degrees a second");
        give(robot, new Call(SPIN, degrees != 0, degrees), (number, driven) ->
            DriveCommand.circle(number, Math.toRadians(degrees) * driven.getHardware().getWheelBase() / 2, 0));
    }

    /** @param left m/s over ground, + forward, likewise right */
    public void wheels(String robot, double left, double right) throws InterruptedException {
        check("setWheelSpeeds: left", left, MOST_SPEED, "m/s");
        check("setWheelSpeeds: right", right, MOST_SPEED, "m/s");
        give(robot, new Call("setWheelSpeeds", left != 0 || right != 0, left, right), (number, driven) -> DriveCommand.wheels(number, left, right));
    }

    /**
     * Along a circle.
     *
     * @param speed m/s
     * @param radius metres, + left, infinite = straight, 0 = in place
     */
    public void circle(String robot, double speed, double radius) throws InterruptedException {
        check("drive: speed", speed, MOST_SPEED, "m/s");
        if (Double.isNaN(radius)) {
            throw new IllegalArgumentException("drive: radius is " + radius + ", legal: metres, + to the left, 0 or infinity");
        }
        give(robot, new Call("drive", speed != 0, speed, radius), (number, driven) -> DriveCommand.circle(number, speed, radius));
    }

    /** @param degrees of a wheel in the middle, + to the left */
    public void steer(String robot, double degrees) throws InterruptedException {
        control.session().scriptDrives();
        control.session().ask(world -> {
            world.order(new ActuatorOrder(ActuatorOrder.Kind.STEERING, ScriptReadings.robot(world, robot).getObject().getName(), degrees));
            return true;
        });
    }

    private static void check(String what, double value, double most, String unit) {
        if (!(Math.abs(value) <= most)) {
            throw new IllegalArgumentException(what + " is " + value + ", legal: " + -most + " to " + most + " " + unit);
        }
    }

    private void give(String robot, Call call, BiFunction<Integer, Robot, DriveCommand> command) throws InterruptedException {
        control.session().scriptDrives();
        String given = control.session().ask(world -> {
            Robot driven = ScriptReadings.robot(world, robot);
            String name = driven.getObject().getName();
            if (driven.getHardware().getWheelRadius() == 0) {
                throw new IllegalArgumentException("robot " + name + " has no driven wheels: robot.addWheel(Wheel(name, radius, width, 1)) adds one");
            }
            if (call.name.equals(SPIN) && driven.getHardware().getWheelBase() == 0) {
                throw new IllegalArgumentException("robot " + name + " can't turn in place: its driven wheels are all in its middle;"
                    + " wheel.move(x, y, z) puts one to the left with x above 0, to the right with x below");
            }
            world.post(command.apply(world.getRobots().indexOf(driven), driven));
            return name;
        });
        control.session().scriptOrders(given, call.name, call.values, call.moves);
    }
}
