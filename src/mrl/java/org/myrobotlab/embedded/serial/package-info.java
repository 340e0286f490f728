// SPDX-License-Identifier: Apache-2.0
/**
 * Reading and recording the bytes of the embedded MyRobotLab's serial service. May use {@code org.myrobotlab.framework}
 * and the types of services. Any thread.
 */
package org.myrobotlab.embedded.serial;
