// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;

/** Distance travelled by the wheels' encoders, millimetres, 16 bit; a reading clears it. */
@Described("distance travelled by the wheels' encoders, millimetres, 16 bit; a reading clears it")
public class Odometer extends SensorObject {
    @Param(doc = "whether it measures the true path of the robot's centre instead of the rotation of its driven "
        + "wheels; default: false")
    private Boolean truePath;

    /** For reading from a file. */
    protected Odometer() {
    }

    /** Counts like a Roomba's. */
    public Odometer(String name) {
        super(name);
        created(Odometer.class);
    }

    /** Returns whether it measures the true path of the robot's centre. */
    public boolean isTruePath() {
        return truePath != null && truePath;
    }

    /**
     * Chooses what it measures. A robot without driven wheels always gets the true path.
     *
     * @param on false, the default: mean rotation of the left and right driven wheels times their nominal radius, so
     *     slipping wheels count; true: path of the robot's centre along its forward axis
     */
    public void setTruePath(boolean on) {
        truePath = checked("truePath", on);
        changed();
    }
}
