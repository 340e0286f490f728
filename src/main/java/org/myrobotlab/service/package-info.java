// SPDX-License-Identifier: Apache-2.0
/**
 * The services SEAR, LIDAR, GPS and Python3, which MyRobotLab finds by name. Scripts, panels and MyRobotLab's inbox
 * threads call their methods. No type of jMonkeyEngine appears in a signature or a field. Uses
 * {@link org.myrobotlab.service.config}, {@link org.myrobotlab.service.gps}, {@link org.myrobotlab.service.lidar},
 * {@link org.myrobotlab.service.sear.export}, {@link org.myrobotlab.service.sear.files},
 * {@link org.myrobotlab.service.sear.netcam}, {@link org.myrobotlab.service.sear.panel},
 * {@link org.myrobotlab.service.sear.python3} and {@link org.myrobotlab.service.sear.records}, and their packages in
 * turn.
 */
package org.myrobotlab.service;
