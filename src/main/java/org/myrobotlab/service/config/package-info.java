/** What MyRobotLab keeps in a service's yml file. Uses nothing else. Plain fields without a lock, as MyRobotLab wants them. */
package org.myrobotlab.service.config;
