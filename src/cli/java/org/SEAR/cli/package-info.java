// SPDX-License-Identifier: Apache-2.0
/**
 * The program {@code sear}: runs scripts in the embedded MyRobotLab, checks projects and lists sensors. May use
 * everything. The main thread.
 */
package org.SEAR.cli;
