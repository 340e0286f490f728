// SPDX-License-Identifier: Apache-2.0
/**
 * {@code sear class}: starts and supervises a program for each pupil. Uses {@link org.SEAR.project.problems} and
 * {@code org.myrobotlab.embedded.web}. The main thread, and one for each pupil's output.
 */
package org.SEAR.cli.classroom;
