/**
 * Records of runs for scripts and panels: beginning and ending them, what is in them, running them again. Uses the running simulation and
 * {@link org.SEAR.record}. Any thread.
 */
package org.myrobotlab.service.sear.records;
