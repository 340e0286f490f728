/**
 * The services SEAR, LIDAR, GPS and Python3, as MyRobotLab finds them by name. Uses {@link org.myrobotlab.service.config},
 * {@link org.myrobotlab.service.gps}, {@link org.myrobotlab.service.lidar}, {@link org.myrobotlab.service.sear.export},
 * {@link org.myrobotlab.service.sear.files}, {@link org.myrobotlab.service.sear.netcam}, {@link org.myrobotlab.service.sear.panel},
 * {@link org.myrobotlab.service.sear.python3} and {@link org.myrobotlab.service.sear.records}, and what these use. Their methods are called by
 * scripts, panels and MyRobotLab's inbox threads; no type of jMonkeyEngine stands in a signature or a field.
 */
package org.myrobotlab.service;
