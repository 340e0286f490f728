// SPDX-License-Identifier: Apache-2.0
/**
 * Messages between MyRobotLab's Arduino service and its firmware MrlComm, version 68: frames, functions and arguments.
 * Uses no other package of SEAR. Any thread. Numbers are big-endian. Source: MyRobotLab's {@code arduinoMsgs.schema}.
 */
package org.SEAR.protocol.mrlcomm;
