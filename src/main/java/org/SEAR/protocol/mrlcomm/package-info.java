/**
 * What MyRobotLab's Arduino service and its firmware MrlComm, version 68, say to each other: frames, functions, arguments. Uses no other package of
 * SEAR. Any thread. Numbers are big-endian. Source: MyRobotLab's {@code arduinoMsgs.schema}.
 */
package org.SEAR.protocol.mrlcomm;
