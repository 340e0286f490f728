/** MyRobotLab's own: what services keep and show. */
package org.myrobotlab.service.data;
