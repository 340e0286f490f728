// SPDX-License-Identifier: Apache-2.0
/**
 * Shared parts of the services: a serial line with time-outs, panel files on the disk, warnings. Uses
 * {@link org.SEAR.files}, {@link org.SEAR.grammar} and {@link org.myrobotlab.serial}, and what these use. Any thread.
 */
package org.myrobotlab.service.link;
