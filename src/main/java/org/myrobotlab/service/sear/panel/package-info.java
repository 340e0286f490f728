/**
 * The world as panels draw it: plain maps for JSON. May use {@link org.myrobotlab.service.sear.readings} and
 * {@link org.myrobotlab.service.sear.run}. On the simulation's thread, or on the caller's for a world that does not run.
 */
package org.myrobotlab.service.sear.panel;
