/** MyRobotLab's own: the base of what describes a type of service. */
package org.myrobotlab.service.meta.abstracts;
