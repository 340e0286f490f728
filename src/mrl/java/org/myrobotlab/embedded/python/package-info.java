// SPDX-License-Identifier: Apache-2.0
/**
 * Jython for the embedded MyRobotLab: runs scripts and callbacks, captures their output, and explains errors. Uses the
 * method search and the out-of-memory reports of {@code org.myrobotlab.embedded}. Scripts run on the caller's thread.
 */
package org.myrobotlab.embedded.python;
