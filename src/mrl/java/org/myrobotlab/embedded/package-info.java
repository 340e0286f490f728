// SPDX-License-Identifier: Apache-2.0
/**
 * The parts of the embedded MyRobotLab that differ from the real one: start, registry of services, messages, files and
 * shutdown. May use {@code org.myrobotlab.framework} and the services. Any thread unless a class says otherwise.
 */
package org.myrobotlab.embedded;
