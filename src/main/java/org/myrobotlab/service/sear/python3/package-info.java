// SPDX-License-Identifier: Apache-2.0
/**
 * The gateway for Python 3 programs, queries of Python about Java objects, and hints for errors of scripts in a real
 * MyRobotLab. Uses {@link org.SEAR.grammar} and {@link org.myrobotlab.service.sear.tcp}. Py4J's threads run the calls,
 * one per thread of a program.
 */
package org.myrobotlab.service.sear.python3;
