/**
 * {@code sear install}: puts the plug-in into a MyRobotLab and takes it out again; looks first, then changes, and undoes what it began. Uses
 * {@link org.myrobotlab.service.link}, which knows the panels' files. The main thread.
 */
package org.SEAR.cli.install;
