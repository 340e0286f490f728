/** What MyRobotLab's service picker shows. Uses nothing else. Any thread. */
package org.myrobotlab.service.meta;
