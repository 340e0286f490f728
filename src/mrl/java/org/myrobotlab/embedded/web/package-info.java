// SPDX-License-Identifier: Apache-2.0
/**
 * The web server of the embedded MyRobotLab: pages, REST calls, messages over web sockets, and access control. It
 * listens on the loopback address by default. May use {@code org.myrobotlab.embedded} and its dependencies. The
 * server's own threads.
 */
package org.myrobotlab.embedded.web;
