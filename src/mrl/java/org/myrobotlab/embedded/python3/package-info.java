/**
 * Scripts of Python 3 in the embedded MyRobotLab: each runs in a process of its own, which calls back by SEAR's door for Python 3. Uses
 * {@link org.myrobotlab.service}.
 */
package org.myrobotlab.embedded.python3;
