/** What MyRobotLab keeps in a service's yml file. Uses no other package of SEAR. Plain fields without a lock, as MyRobotLab wants them. */
package org.myrobotlab.service.config;
