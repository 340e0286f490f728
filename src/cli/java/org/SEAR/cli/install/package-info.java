// SPDX-License-Identifier: Apache-2.0
/**
 * {@code sear install}: installs the plug-in in a MyRobotLab and removes it. Plans all changes first, and rolls back
 * after a failure. Uses {@link org.myrobotlab.service.link}, which knows the panels' files. The main thread.
 */
package org.SEAR.cli.install;
