/**
 * MyRobotLab's own: the service and what it sends, subscribes to and starts with; each name and signature is the real one's, see
 * docs/embedded-and-real.md. Any thread unless a class says otherwise.
 */
package org.myrobotlab.framework;
