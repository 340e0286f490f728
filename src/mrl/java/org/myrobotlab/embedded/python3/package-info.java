// SPDX-License-Identifier: Apache-2.0
/**
 * Python 3 scripts in the embedded MyRobotLab: each runs in its own process, which calls SEAR over its TCP port for
 * Python 3. Uses {@link org.myrobotlab.service}.
 */
package org.myrobotlab.embedded.python3;
