/**
 * {@code sear class}: a program of its own for each pupil, looked after. Uses {@link org.SEAR.project.problems} and
 * {@code org.myrobotlab.embedded.web}. The main thread, and one for each pupil's output.
 */
package org.SEAR.cli.classroom;
