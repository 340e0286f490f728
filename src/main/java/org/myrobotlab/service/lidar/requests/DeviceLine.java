// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar.requests;

import org.myrobotlab.service.link.SerialLink;

/** The serial port of a driver. */
public interface DeviceLine {
    void write(byte[] bytes);

    void setBaud(int baud);

    int getBaud();

    /** Returns seconds for time-outs. */
    double now();

    /** Returns the line of a connection. */
    static DeviceLine of(SerialLink link) {
        return new DeviceLine() {
            @Override
            public void write(byte[] bytes) {
                link.write(bytes);
            }

            @Override
            public void setBaud(int baud) {
                link.setBaud(baud);
            }

            @Override
            public int getBaud() {
                return link.getBaud();
            }

            @Override
            public double now() {
                return link.timeOutNow();
            }
        };
    }
}
