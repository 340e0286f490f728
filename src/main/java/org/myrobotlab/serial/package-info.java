/**
 * Virtual serial ports on MyRobotLab's own, and the factory that scripts make them with. Uses {@link org.SEAR.protocol}, and what that uses. Any
 * thread; each open port has a thread that hands bytes to its listeners.
 */
package org.myrobotlab.serial;
