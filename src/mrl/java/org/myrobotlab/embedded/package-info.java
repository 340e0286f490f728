/**
 * What the embedded MyRobotLab is made of and the real one does otherwise: its start, the registry of services, messages between them, files and the
 * end. May use {@code org.myrobotlab.framework} and the services. Any thread unless a class says otherwise.
 */
package org.myrobotlab.embedded;
