/**
 * One simulation from start to end: its thread, its clock, its ports, its window. May use {@link org.myrobotlab.service.sear.lockstep} and
 * {@link org.SEAR.view}. Any thread.
 */
package org.myrobotlab.service.sear.run;
