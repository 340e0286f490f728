/** Entries of MyRobotLab's service picker. Uses no other package of SEAR. Any thread. */
package org.myrobotlab.service.meta;
