package org.SEAR.cli.contests;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.SEAR.sensors.OdometerSensor;
import org.SEAR.sensors.Sensor;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;

/**
 * What a script in a contest has as {@code sear}: the calls of a script with one robot, of its own robot only. Units and signs are those of
 * docs/scripting.md. Public because scripts in Python call it; the thread of the script.
 */
public final class EntrantSear {
    private static final double MOST_SPEED = 100;
    private static final double MOST_SPIN = 3600;

    private final Entrant entrant;
    private boolean started;

    /** What a script in a contest has as {@code Runtime}. */
    public static final class Services {
        private final EntrantSear sear;

        Services(EntrantSear sear) {
            this.sear = sear;
        }

        /**
         * The one service there is.
         *
         * @throws IllegalArgumentException for another
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

    /** Nothing: the contest has begun. There for scripts that were written for one robot alone. */
    public void startSimulation() {
        started = true;
    }

    /** The script leaves its robot standing. */
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
        give("driveStraight: speed", speed, MOST_SPEED, number -> DriveCommand.wheels(number, speed, speed));
    }

    public void spin(double degPerSecond) {
        double base = entrant.call(world -> entrant.robot().getHardware().getWheelBase());
        if (base == 0) {
            throw new IllegalArgumentException("robot " + entrant.getRobot() + " can't turn in place: its driven wheels are all in its middle");
        }
        give("spin: speed", degPerSecond, MOST_SPIN, number -> DriveCommand.circle(number, Math.toRadians(degPerSecond) * base / 2, 0));
    }

    public void setWheelSpeeds(double left, double right) {
        double larger = Math.abs(left) > Math.abs(right) || Double.isNaN(left) ? left : right;
        give("setWheelSpeeds: speed", larger, MOST_SPEED, number -> DriveCommand.wheels(number, left, right));
    }

    public void drive(double speed, double radius) {
        if (Double.isNaN(radius)) {
            throw new IllegalArgumentException("drive: radius is " + radius + ", legal: metres, + to the left, 0 or infinity");
        }
        give("drive: speed", speed, MOST_SPEED, number -> DriveCommand.circle(number, speed, radius));
    }

    private void give(String what, double value, double most, Function<Integer, DriveCommand> command) {
        if (!(Math.abs(value) <= most)) {
            throw new IllegalArgumentException(String.format(Locale.ROOT, "%s is %s, legal: %s to %s", what, value, -most, most));
        }
        act(world -> {
            if (entrant.robot().getHardware().getWheelRadius() == 0) {
                throw new IllegalArgumentException("robot " + entrant.getRobot() + " has no driven wheels");
            }
            world.post(command.apply(entrant.number()));
        });
    }

    public void setSteering(double degrees) {
        act(world -> world.order(new ActuatorOrder(ActuatorOrder.Kind.STEERING, entrant.getRobot(), degrees)));
    }

    public void setMotorPower(String name, double power) {
        order(ActuatorOrder.Kind.POWER, name, power);
    }

    public void setMotorSpeed(String name, double speed) {
        order(ActuatorOrder.Kind.SPEED, name, speed);
    }

    public double getMotorSpeed(String name) {
        return entrant.call(world -> world.getMotor(entrant.part(name)).getSpeed());
    }

    public long getEncoder(String name) {
        return entrant.call(world -> world.getMotor(entrant.part(name)).getCounts());
    }

    public void setServo(String name, double degrees) {
        order(ActuatorOrder.Kind.ANGLE, name, degrees);
    }

    public double getServo(String name) {
        return entrant.call(world -> world.getServo(entrant.part(name)).getAngle());
    }

    public void setLed(String name, double brightness) {
        order(ActuatorOrder.Kind.BRIGHTNESS, name, brightness);
    }

    private void order(ActuatorOrder.Kind kind, String name, double value) {
        act(world -> world.order(new ActuatorOrder(kind, entrant.part(name), value)));
    }

    private void act(java.util.function.Consumer<Simulation> what) {
        entrant.call(world -> {
            what.accept(world);
            return true;
        });
    }

    // ---- reading ---------------------------------------------------------------------------------------------------

    /** Names of its robot's sensors. */
    public List<String> getSensorNames() {
        return entrant.call(world -> entrant.robot().getSensors().stream().map(one -> one.getParameters().getName()).sorted()
            .collect(Collectors.toList()));
    }

    public Object getReading(String name) {
        return entrant.call(world -> world.read(entrant.part(name)).value());
    }

    public String getSensorUnit(String name) {
        return entrant.call(world -> world.getUnit(entrant.part(name)));
    }

    private <T> T read(String name, Class<T> type) {
        Object value = getReading(name);
        if (!type.isInstance(value)) {
            throw new IllegalArgumentException("sensor " + name + " is of another kind; getReading(\"" + name + "\") answers for each");
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
            return entrant.robot().getHardware().getPath();
        });
    }
}
