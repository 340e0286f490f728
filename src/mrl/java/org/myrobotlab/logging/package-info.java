/** MyRobotLab's own: where loggers come from. Any thread. */
package org.myrobotlab.logging;
