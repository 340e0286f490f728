// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;

/** Distance travelled by the robot's centre, millimetres, 16 bit; a reading clears it. */
@Described("distance travelled by the robot's centre, millimetres, 16 bit; a reading clears it")
public class Odometer extends SensorObject {

    /** For reading from a file. */
    protected Odometer() {
    }

    /** Counts like a Roomba's. */
    public Odometer(String name) {
        super(name);
        created(Odometer.class);
    }
}
