package org.myrobotlab.service.sear.readings;

import org.SEAR.robot.DriveOrder;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.DriveCommand;
import org.myrobotlab.service.sear.run.SimulationControl;

/**
 * Driving by call. A command goes straight to the wheels' motors, at the start of the next step, and holds until the next one, by call or through the
 * robot's port. A robot is meant by its name, the first by null. Any thread.
 */
public final class ScriptDriving {
    private final SimulationControl control;

    public ScriptDriving(SimulationControl control) {
        this.control = control;
    }

    /** As its call says it. */
    public void give(String robot, DriveOrder order) throws InterruptedException {
        control.session().scriptDrives();
        String given = control.session().ask(world -> {
            Robot driven = ScriptReadings.robot(world, robot);
            world.post(DriveCommand.of(world, driven, order));
            return driven.getObject().getName();
        });
        control.session().scriptOrders(given, order.call, order.values, order.moves);
    }

    /** @param degrees of a wheel in the middle, + to the left */
    public void steer(String robot, double degrees) throws InterruptedException {
        control.session().scriptDrives();
        control.session().ask(world -> {
            world.order(new ActuatorOrder(ActuatorOrder.Kind.STEERING, ScriptReadings.robot(world, robot).getObject().getName(), degrees));
            return true;
        });
    }
}
