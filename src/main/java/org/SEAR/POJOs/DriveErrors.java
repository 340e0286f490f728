// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;

/**
 * Errors of a robot's drive: tolerances of its wheels, its encoders and its steering. All parameters default to 0. The
 * simulation's seed and the robot's name choose each deviation: plus or minus half to all of its greatest value.
 * Immutable, any thread.
 */
@Described("the errors of a robot's drive: wheels, encoders, steering; the simulation's seed chooses each deviation")
public final class DriveErrors {
    /**
     * Typical values of ready robots; data sheets state no tolerances. The kinds of wheel errors are those of UMBmark
     * (Borenstein and Feng, University of Michigan, report UM-MEAM-94-22, 1994): size, difference, wheelbase. Their
     * sizes let dead reckoning miss 1 to 2 % of a way in squares. A Create 2's encoder has 508.8 counts per turn, so
     * half a count is 0.35 degrees. A hobby servo gets a pulse every 20 ms. A passenger car understeers by 2 to 3
     * degrees per g.
     */
    private static final Map<String, DriveErrors> PRESETS = new TreeMap<>(Map.of(
        "roomba400", new DriveErrors(1.7, 0.005, 0.2, 0.35, 0.001, 0, 0, 0),
        "create", new DriveErrors(1.7, 0.005, 0.2, 0.35, 0.001, 0, 0, 0),
        "create2", new DriveErrors(1.7, 0.005, 0.2, 0.35, 0.001, 0, 0, 0),
        "rover", new DriveErrors(1.6, 0.005, 0.2, 0.5, 0.002, 0, 0, 0),
        "fourWheeled", new DriveErrors(1.6, 0.005, 0.2, 0.5, 0.002, 0, 0, 0),
        "car", new DriveErrors(1.6, 0.005, 0.2, 0.5, 0.002, 2, 0.02, 0.25)));

    @Param(doc = "greatest deviation of all driven wheels' radius from the nominal one", unit = "%", max = 20)
    private double radius;
    @Param(doc = "greatest further deviation of each driven wheel's radius", unit = "%", max = 20)
    private double difference;
    @Param(doc = "greatest deviation of the distance between left and right wheels that point ahead",
        unit = "%", max = 20)
    private double track;
    @Param(doc = "standard deviation of the error of an encoder, in degrees of its wheel; does not add up",
        unit = "deg", max = 360)
    private double encoderNoise;
    @Param(doc = "mean share of counts that an encoder misses", max = 0.5)
    private double missed;
    @Param(doc = "angle that the steering turns before steered wheels follow", unit = "deg", max = 90)
    private double steeringPlay;
    @Param(doc = "dead time of steering commands, unless a servo steers", unit = "s", max = 1)
    private double steeringDelay;
    @Param(doc = "angle by which steered wheels turn less, per m/s^2 of lateral acceleration",
        unit = "deg s^2/m", max = 10)
    private double understeer;

    /** Without errors. */
    public DriveErrors() {
    }

    /** With all parameters. */
    public DriveErrors(double radius, double difference, double track, double encoderNoise, double missed,
        double steeringPlay, double steeringDelay, double understeer) {
        this.radius = checked("radius", radius);
        this.difference = checked("difference", difference);
        this.track = checked("track", track);
        this.encoderNoise = checked("encoderNoise", encoderNoise);
        this.missed = checked("missed", missed);
        this.steeringPlay = checked("steeringPlay", steeringPlay);
        this.steeringDelay = checked("steeringDelay", steeringDelay);
        this.understeer = checked("understeer", understeer);
    }

    /**
     * Returns typical errors of a ready robot.
     *
     * @param robot roomba400, create, create2, rover, fourWheeled or car
     * @throws IllegalArgumentException with the legal names
     */
    public static DriveErrors of(String robot) {
        DriveErrors found = robot == null ? null : PRESETS.get(robot);
        if (found == null) {
            throw new IllegalArgumentException("drive errors of " + ParameterTable.quote(robot) + ", legal: "
                + String.join(", ", PRESETS.keySet()));
        }
        return found;
    }

    private static double checked(String element, double value) {
        Parameter parameter = ParameterTable.of(DriveErrors.class).get(element);
        if (!parameter.isLegal(value)) {
            throw new IllegalArgumentException(
                String.format(Locale.ROOT, "DriveErrors: %s is %s, legal: %s", element, Parameter.format(value),
                parameter.legal()));
        }
        return value + 0.0;
    }

    public double getRadius() {
        return radius;
    }

    public double getDifference() {
        return difference;
    }

    public double getTrack() {
        return track;
    }

    public double getEncoderNoise() {
        return encoderNoise;
    }

    public double getMissed() {
        return missed;
    }

    public double getSteeringPlay() {
        return steeringPlay;
    }

    public double getSteeringDelay() {
        return steeringDelay;
    }

    public double getUndersteer() {
        return understeer;
    }
}
