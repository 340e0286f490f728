/** Base class of MyRobotLab's service descriptions. */
package org.myrobotlab.service.meta.abstracts;
