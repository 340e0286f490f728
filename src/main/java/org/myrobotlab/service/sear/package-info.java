/**
 * What the parts of the SEAR service need of it: whom they tell, and a reading as scripts hear of it. The parts are the packages below, one for each
 * matter, and all of them may use this one, {@link org.SEAR.simulator} and below. Uses no other package of SEAR. Callers' threads and the
 * simulation's meet in them; each class says which it is for.
 */
package org.myrobotlab.service.sear;
