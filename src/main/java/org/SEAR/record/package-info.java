/**
 * Records of runs: writing them while a simulation runs, reading them as files of strangers, running their commands again, values over time. Uses
 * {@link org.SEAR.simulator}, and what that uses. It knows nothing of MyRobotLab. Two threads of its own: the writer of a record,
 * and one that makes files of its pictures.
 */
package org.SEAR.record;
