/**
 * The world as panels draw it: classes whose fields are the JSON. Uses {@link org.SEAR.record} and {@link org.myrobotlab.service.sear.readings}, and
 * what these use. On the simulation's thread, or on the caller's for a world that does not run.
 */
package org.myrobotlab.service.sear.panel;
