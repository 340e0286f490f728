// SPDX-License-Identifier: Apache-2.0
/**
 * Records of runs: writing them during a simulation, reading files from any source, rerunning their commands, and
 * values over time. Uses {@link org.SEAR.simulator} and its packages in turn; independent of MyRobotLab. It has two
 * threads: one writes a record, one encodes its pictures.
 */
package org.SEAR.record;
