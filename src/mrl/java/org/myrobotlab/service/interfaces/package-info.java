/** MyRobotLab's own: what services offer each other; each name and signature is the real one's. */
package org.myrobotlab.service.interfaces;
