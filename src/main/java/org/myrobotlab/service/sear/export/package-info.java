/**
 * Virtual ports for programs outside: pseudo-terminals and TCP. May use {@link org.myrobotlab.service.sear.run}. A thread for each program that has
 * come in.
 */
package org.myrobotlab.service.sear.export;
