/**
 * The services SEAR, LIDAR and GPS, as MyRobotLab finds them by name. May use everything. Their methods are called by scripts, panels and
 * MyRobotLab's inbox threads; no type of jMonkeyEngine stands in a signature or a field.
 */
package org.myrobotlab.service;
