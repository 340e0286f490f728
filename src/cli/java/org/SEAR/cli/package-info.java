/** The program {@code sear}: runs a script in the embedded MyRobotLab, checks projects, lists sensors. May use everything. The main thread. */
package org.SEAR.cli;
