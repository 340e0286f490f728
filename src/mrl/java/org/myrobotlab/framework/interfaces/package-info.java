// SPDX-License-Identifier: Apache-2.0
/** Interfaces of MyRobotLab's services. Names and signatures are those of the real MyRobotLab. */
package org.myrobotlab.framework.interfaces;
