// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.contests;

import java.util.List;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.Servo;
import org.SEAR.robot.DriveOrder;
import org.SEAR.sensors.OdometerSensor;
import org.SEAR.sensors.Sensor;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;

/**
 * The object {@code sear} of a script in a contest: the calls for a single robot, applied to the script's own robot.
 * Units and signs are those of docs/scripting.md. Public for scripts in Python; the script's thread.
 */
public final class EntrantSear {
    private final Entrant entrant;
    private boolean started;

    /** The object {@code Runtime} of a script in a contest. */
    public static final class Services {
        private final EntrantSear sear;

        Services(EntrantSear sear) {
            this.sear = sear;
        }

        /**
         * Returns the contest's only service.
         *
         * @throws IllegalArgumentException for another type
         */
        public EntrantSear start(String name, String type) {
            if (!type.equals("SEAR")) {
                throw new IllegalArgumentException("there is no service " + type + " in a contest, legal: SEAR");
            }
            return sear;
        }
    }

    EntrantSear(Entrant entrant) {
        this.entrant = entrant;
    }

    // ---- time ------------------------------------------------------------------------------------------------------

    /** Does nothing: the contest is running. Exists for scripts that were written for a single robot. */
    public void startSimulation() {
        started = true;
    }

    /** Stops the robot. */
    public void stopSimulation() {
        if (started) {
            driveStraight(0);
        }
        started = false;
    }

    public boolean isSimulating() {
        return started;
    }

    public void simSleep(double seconds) {
        if (!(seconds >= 0) || Double.isInfinite(seconds)) {
            throw new IllegalArgumentException("simSleep of " + seconds + " s, legal: 0 or more");
        }
        entrant.sleep(seconds);
    }

    public double getTime() {
        return entrant.call(Simulation::getTime);
    }

    // ---- driving ---------------------------------------------------------------------------------------------------

    public void driveStraight(double speed) {
        give(DriveOrder.straight(speed));
    }

    public void spin(double degPerSecond) {
        give(DriveOrder.spin(degPerSecond));
    }

    public void setWheelSpeeds(double left, double right) {
        give(DriveOrder.wheels(left, right));
    }

    public void drive(double speed, double radius) {
        give(DriveOrder.circle(speed, radius));
    }

    public void driveVelocity(double speed, double degPerSecond) {
        give(DriveOrder.velocity(speed, degPerSecond));
    }

    private void give(DriveOrder order) {
        act(world -> world.post(DriveCommand.of(world, entrant.robot(), order)));
    }

    public void setSteering(double degrees) {
        act(world -> world.order(new ActuatorOrder(ActuatorOrder.Kind.STEERING, entrant.getRobot(), degrees)));
    }

    public void setMotorPower(String name, double power) {
        order(ActuatorOrder.Kind.POWER, Motor.class, name, power);
    }

    public void setMotorSpeed(String name, double speed) {
        order(ActuatorOrder.Kind.SPEED, Motor.class, name, speed);
    }

    public double getMotorSpeed(String name) {
        return entrant.call(world -> world.getMotor(entrant.part(Motor.class, name)).getSpeed());
    }

    public long getEncoder(String name) {
        return entrant.call(world -> world.getMotor(entrant.part(Motor.class, name)).getCounts());
    }

    public void setServo(String name, double degrees) {
        order(ActuatorOrder.Kind.ANGLE, Servo.class, name, degrees);
    }

    public double getServo(String name) {
        return entrant.call(world -> world.getServo(entrant.part(Servo.class, name)).getAngle());
    }

    public void setLed(String name, double brightness) {
        order(ActuatorOrder.Kind.BRIGHTNESS, Led.class, name, brightness);
    }

    private void order(ActuatorOrder.Kind kind, Class<?> type, String name, double value) {
        act(world -> world.order(new ActuatorOrder(kind, entrant.part(type, name), value)));
    }

    private void act(java.util.function.Consumer<Simulation> what) {
        entrant.call(world -> {
            what.accept(world);
            return true;
        });
    }

    // ---- reading ---------------------------------------------------------------------------------------------------

    /** Returns the names of the robot's sensors. */
    public List<String> getSensorNames() {
        return entrant.call(world -> entrant.sensors());
    }

    public Object getReading(String name) {
        return entrant.call(world -> world.read(entrant.sensor(name)).value());
    }

    public String getSensorUnit(String name) {
        return entrant.call(world -> world.getUnit(entrant.sensor(name)));
    }

    private <T> T read(String name, Class<T> type) {
        Object value = getReading(name);
        if (!type.isInstance(value)) {
            throw new IllegalArgumentException("sensor " + name + " is of another kind; getReading(\"" + name
                + "\") reads any sensor");
        }
        return type.cast(value);
    }

    public double getDistanceResult(String name) {
        return read(name, Double.class);
    }

    public float[] getLidarResult(String name) {
        return read(name, float[].class);
    }

    public double[] getGpsResult(String name) {
        return read(name, double[].class);
    }

    public double getCompassResult(String name) {
        return read(name, Double.class);
    }

    public String getAccelResult(String name) {
        return read(name, String.class);
    }

    public String getGyroResult(String name) {
        return read(name, String.class);
    }

    public double getOdomResult() {
        return entrant.call(world -> {
            for (Sensor<?> sensor : entrant.robot().getSensors()) {
                if (sensor instanceof OdometerSensor) {
                    return ((OdometerSensor) sensor).take(entrant.robot().getTruth()).getMetres();
                }
            }
            return entrant.robot().getTruth().odometry();
        });
    }
}
