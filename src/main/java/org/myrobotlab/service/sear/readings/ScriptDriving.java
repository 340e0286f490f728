// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.readings;

import org.SEAR.robot.DriveOrder;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.DriveCommand;
import org.myrobotlab.service.sear.run.SimulationControl;

/**
 * Drive commands. A command sets the wheels' motors at the next step and lasts until the next command, by call or
 * through the robot's port. Null as a robot's name means the first robot. Any thread.
 */
public final class ScriptDriving {
    private final SimulationControl control;

    public ScriptDriving(SimulationControl control) {
        this.control = control;
    }

    /** Gives a robot a drive command. */
    public void give(String robot, DriveOrder order) throws InterruptedException {
        control.session().scriptDrives();
        String given = control.session().ask(world -> {
            Robot driven = ScriptReadings.robot(world, robot);
            world.post(DriveCommand.of(world, driven, order));
            return driven.getObject().getName();
        });
        control.session().scriptOrders(given, order.call, order.values, order.moves);
    }

    /** @param degrees angle of a wheel in the middle, left positive */
    public void steer(String robot, double degrees) throws InterruptedException {
        control.session().scriptDrives();
        control.session().ask(world -> {
            world.order(new ActuatorOrder(ActuatorOrder.Kind.STEERING, ScriptReadings.robot(world, robot).getObject()
                .getName(), degrees));
            return true;
        });
    }
}
