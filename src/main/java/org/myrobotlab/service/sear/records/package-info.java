/**
 * Records of runs for scripts and panels: beginning and ending them, what is in them, running them again, plots of them; plans of worlds. Uses
 * {@link org.SEAR.plan}, {@link org.SEAR.record} and {@link org.myrobotlab.service.sear.readings}, and what these use. Any thread.
 */
package org.myrobotlab.service.sear.records;
