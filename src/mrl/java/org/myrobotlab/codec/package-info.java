// SPDX-License-Identifier: Apache-2.0
/** MyRobotLab's codec: service names, and messages as JSON, as far as scripts and services use them. Any thread. */
package org.myrobotlab.codec;
