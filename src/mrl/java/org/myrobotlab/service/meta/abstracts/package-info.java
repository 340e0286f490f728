// SPDX-License-Identifier: Apache-2.0
/** Base class of MyRobotLab's service descriptions. */
package org.myrobotlab.service.meta.abstracts;
