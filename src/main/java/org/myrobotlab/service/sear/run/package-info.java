// SPDX-License-Identifier: Apache-2.0
/**
 * One simulation from start to end: its thread, clock, ports and window. Uses {@link org.SEAR.view},
 * {@link org.myrobotlab.service.link} and {@link org.myrobotlab.service.sear.lockstep}, and what these use. Any thread.
 */
package org.myrobotlab.service.sear.run;
