// SPDX-License-Identifier: Apache-2.0
/**
 * Virtual serial ports on top of MyRobotLab's, and the factory with which scripts create them. Uses
 * {@link org.SEAR.protocol} and its dependencies. Any thread; each open port has a thread that delivers bytes to its
 * listeners.
 */
package org.myrobotlab.serial;
