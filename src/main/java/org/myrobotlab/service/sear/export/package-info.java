/**
 * Virtual ports for external programs: pseudo-terminals, TCP and RFC 2217. Uses
 * {@link org.myrobotlab.service.sear.run}, and what that uses. One thread per export.
 */
package org.myrobotlab.service.sear.export;
