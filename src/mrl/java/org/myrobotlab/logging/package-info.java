/** MyRobotLab's logger factory. Any thread. */
package org.myrobotlab.logging;
