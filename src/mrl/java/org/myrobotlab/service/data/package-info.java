// SPDX-License-Identifier: Apache-2.0
/** Data classes of MyRobotLab's services. */
package org.myrobotlab.service.data;
