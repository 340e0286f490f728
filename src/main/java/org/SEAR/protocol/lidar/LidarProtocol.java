// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lidar;

/** Protocols of LIDARs; each has one firmware for all its models. */
public enum LidarProtocol {
    /** SICK's telegrams of the LMS2xx. */
    LMS,
    /** SICK's Command Language A and B of LMS1xx and TiM. */
    COLA,
    /** Hokuyo's SCIP 2.0. */
    SCIP,
    /** Slamtec's requests and responses. */
    RPLIDAR
}
