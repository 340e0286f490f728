package org.SEAR.protocol.lidar;

/** What a LIDAR speaks; each has one firmware, which answers for all models of that protocol. */
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
