/**
 * Virtual ports for programs outside: pseudo-terminals, TCP and RFC 2217. Uses {@link org.myrobotlab.service.sear.run}, and what that uses. A thread
 * for each export.
 */
package org.myrobotlab.service.sear.export;
