// SPDX-License-Identifier: Apache-2.0
package org.SEAR.lessons;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.SEAR.geometry.Pose;

/**
 * Ground truth of one robot at each step of a run, and the times of its bumps. Metres, x north, z east; seconds since
 * the start or last reset; headings in degrees clockwise from north. Public because checks in Python call it. One
 * thread.
 */
public final class Trail {
    /** Numbers of a moment: time, x, y, z, heading. */
    private static final int SIZE = 5;
    private static final int X = 1;
    private static final int Y = 2;
    private static final int Z = 3;
    private static final int HEADING = 4;
    /** A contact that returns within this time belongs to the same bump, for example while scraping along a wall, s. */
    private static final double SAME_BUMP = 0.5;
    /** Maximum movement, in metres, within {@link #STANDS_SECONDS} for a robot to count as standing. */
    private static final double STANDS = 0.005;
    private static final double STANDS_SECONDS = 0.5;

    private final String name;
    private final List<Double> bumps = new ArrayList<>();
    private double[] moments = new double[SIZE * 1024];
    private int count;
    private double lastTouch = Double.NEGATIVE_INFINITY;

    /** Creates an empty trail. */
    public Trail(String name) {
        this.name = name;
    }

    void clear() {
        count = 0;
        bumps.clear();
        lastTouch = Double.NEGATIVE_INFINITY;
    }

    /**
     * Adds the next moment.
     *
     * @param touched whether any part except a wheel touches something
     */
    public void add(double time, Pose pose, boolean touched) {
        if (moments.length < SIZE * (count + 1)) {
            moments = Arrays.copyOf(moments, 2 * moments.length);
        }
        double[] now = {time, pose.x, pose.y, pose.z, pose.heading()};
        System.arraycopy(now, 0, moments, SIZE * count, SIZE);
        count++;
        if (touched) {
            if (time - lastTouch > SAME_BUMP) {
                bumps.add(time);
            }
            lastTouch = time;
        }
    }

    private double at(int moment, int number) {
        return moments[SIZE * moment + number];
    }

    private double[] all(int number) {
        double[] values = new double[count];
        for (int i = 0; i < count; i++) {
            values[i] = at(i, number);
        }
        return values;
    }

    public String getName() {
        return name;
    }

    /** Returns the time of each moment: the start and the end of each step of 1/60 s. */
    public double[] getTimes() {
        return all(0);
    }

    /** Returns metres north at each moment. */
    public double[] getX() {
        return all(X);
    }

    /** Returns metres up at each moment. */
    public double[] getY() {
        return all(Y);
    }

    /** Returns metres east at each moment. */
    public double[] getZ() {
        return all(Z);
    }

    /** Returns the heading at each moment, (-180, 180]. */
    public double[] getHeadings() {
        return all(HEADING);
    }

    /** Returns the times at which any part except a wheel began to touch something. */
    public List<Double> getBumps() {
        return Collections.unmodifiableList(bumps);
    }

    /** Returns the horizontal distance travelled, metres. */
    public double getLength() {
        double length = 0;
        for (int i = 1; i < count; i++) {
            length += Math.hypot(at(i, X) - at(i - 1, X), at(i, Z) - at(i - 1, Z));
        }
        return length;
    }

    /**
     * Returns whether the robot stands at the end: it moved by at most 5 mm in the last 0.5 s, or in all of a shorter
     * run.
     */
    public boolean isStanding() {
        int last = count - 1;
        for (int i = last; i >= 0 && at(last, 0) - at(i, 0) <= STANDS_SECONDS; i--) {
            if (Math.hypot(at(last, X) - at(i, X), at(last, Z) - at(i, Z)) > STANDS) {
                return false;
            }
        }
        return count > 0 && (at(last, 0) >= STANDS_SECONDS || getLength() <= STANDS);
    }

    private double far(int moment, double x, double z) {
        return Math.hypot(at(moment, X) - x, at(moment, Z) - z);
    }

    /** Returns the final distance from a point, metres. */
    public double endsFrom(double x, double z) {
        return count == 0 ? Double.POSITIVE_INFINITY : far(count - 1, x, z);
    }

    /** Returns the smallest distance from a point, metres. */
    public double nearest(double x, double z) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            nearest = Math.min(nearest, far(i, x, z));
        }
        return nearest;
    }

    /**
     * Returns the smallest distance from each of several points visited in order, metres. A point counts once all
     * earlier points have been reached. For a point that was not reached, only moments after the last reached one
     * count.
     *
     * @param places {x, z} each
     * @param within metres that count as reached
     */
    public double[] inOrder(List<? extends List<? extends Number>> places, double within) {
        double[] nearest = new double[places.size()];
        int from = 0;
        for (int place = 0; place < nearest.length; place++) {
            double x = places.get(place).get(0).doubleValue();
            double z = places.get(place).get(1).doubleValue();
            nearest[place] = Double.POSITIVE_INFINITY;
            boolean reached = false;
            for (int i = from; i < count && !(reached && far(i, x, z) > within); i++) {
                if (far(i, x, z) < nearest[place]) {
                    nearest[place] = far(i, x, z);
                    from = nearest[place] <= within ? i : from;
                }
                reached |= far(i, x, z) <= within;
            }
        }
        return nearest;
    }

    /**
     * Returns how many points the robot reached in order.
     *
     * @param places {x, z} each
     * @param within metres that count as reached
     */
    public int reached(List<? extends List<? extends Number>> places, double within) {
        int number = 0;
        for (double nearest : inOrder(places, within)) {
            if (nearest > within) {
                break;
            }
            number++;
        }
        return number;
    }

    /**
     * Returns when the robot had reached all points in order.
     *
     * @return seconds; -1 if it did not reach all
     */
    public double when(List<? extends List<? extends Number>> places, double within) {
        int place = 0;
        for (int i = 0; i < count && place < places.size(); i++) {
            while (place < places.size()
                    && far(i, places.get(place).get(0).doubleValue(), places.get(place).get(1).doubleValue())
                        <= within) {
                place++;
                if (place == places.size()) {
                    return at(i, 0);
                }
            }
        }
        return -1;
    }

    /**
     * Returns the distance from a polyline at each moment.
     *
     * @param corners {x, z} each, joined by straight lines
     */
    public double[] distancesFrom(List<? extends List<? extends Number>> corners) {
        double[] distances = new double[count];
        for (int i = 0; i < count; i++) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int k = 1; k < corners.size(); k++) {
                nearest = Math.min(nearest, fromPiece(at(i, X), at(i, Z), corners.get(k - 1), corners.get(k)));
            }
            distances[i] = nearest;
        }
        return distances;
    }

    private static double fromPiece(double x, double z, List<? extends Number> a, List<? extends Number> b) {
        double ax = a.get(0).doubleValue();
        double az = a.get(1).doubleValue();
        double alongX = b.get(0).doubleValue() - ax;
        double alongZ = b.get(1).doubleValue() - az;
        double square = alongX * alongX + alongZ * alongZ;
        double share = square == 0 ? 0 : Math.max(0, Math.min(1, ((x - ax) * alongX + (z - az) * alongZ) / square));
        return Math.hypot(x - ax - share * alongX, z - az - share * alongZ);
    }
}
