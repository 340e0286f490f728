// SPDX-License-Identifier: Apache-2.0
/**
 * The services' configurations, which MyRobotLab stores in yml files. Uses no other package of SEAR. MyRobotLab
 * requires plain fields without a lock.
 */
package org.myrobotlab.service.config;
