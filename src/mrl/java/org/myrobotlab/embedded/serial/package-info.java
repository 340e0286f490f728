/**
 * How the embedded MyRobotLab's serial service reads bytes, waits for them and records them. May use {@code org.myrobotlab.framework} and the types
 * of services. Any thread.
 */
package org.myrobotlab.embedded.serial;
