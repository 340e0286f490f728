/** MyRobotLab's own: what a service can be taken for; each name and signature is the real one's. */
package org.myrobotlab.framework.interfaces;
