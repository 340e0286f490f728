/** What MyRobotLab's service picker shows. Uses no other package of SEAR. Any thread. */
package org.myrobotlab.service.meta;
