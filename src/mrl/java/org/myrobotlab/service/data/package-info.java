/** Data classes of MyRobotLab's services. */
package org.myrobotlab.service.data;
