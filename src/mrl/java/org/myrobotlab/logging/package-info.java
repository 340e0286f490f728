// SPDX-License-Identifier: Apache-2.0
/** MyRobotLab's logger factory. Any thread. */
package org.myrobotlab.logging;
