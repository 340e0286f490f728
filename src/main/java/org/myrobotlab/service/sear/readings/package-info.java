/**
 * Readings of sensors as scripts ask for them and as they are published, and driving by call. Uses {@link org.myrobotlab.service.sear.run}, and what
 * that uses. Any thread; the simulation's answers the questions.
 */
package org.myrobotlab.service.sear.readings;
