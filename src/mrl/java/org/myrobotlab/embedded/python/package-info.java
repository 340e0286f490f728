/**
 * Jython for the embedded MyRobotLab: runs scripts and callbacks, takes what they print, says what went wrong. Uses of the embedded MyRobotLab what
 * finds methods and tells of lost memory. Scripts run on the thread of whoever calls.
 */
package org.myrobotlab.embedded.python;
