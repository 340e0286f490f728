/**
 * The web server of the embedded MyRobotLab, on the loopback address unless told otherwise: pages, REST calls, messages over a WebSocket, and who may
 * call. May use
 * {@code org.myrobotlab.embedded} and what it uses. The server's own threads.
 */
package org.myrobotlab.embedded.web;
