// SPDX-License-Identifier: Apache-2.0
/** Entries of MyRobotLab's service picker. Uses no other package of SEAR. Any thread. */
package org.myrobotlab.service.meta;
