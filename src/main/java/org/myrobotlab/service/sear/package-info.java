/**
 * Between the SEAR service and the simulation: the running session, lock-step, exported ports, transfers, readings for panels. May use {@link
 * org.SEAR.view}, {@link org.SEAR.simulator} and below. Callers' threads and the simulation's meet here; each class says which it is for.
 */
package org.myrobotlab.service.sear;
