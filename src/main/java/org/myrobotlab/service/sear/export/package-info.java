/**
 * Virtual ports for programs outside: pseudo-terminals, TCP and RFC 2217. May use {@link org.myrobotlab.service.sear.run}. A thread for each
 * export.
 */
package org.myrobotlab.service.sear.export;
