// SPDX-License-Identifier: Apache-2.0
/**
 * Virtual ports for external programs: pseudo-terminals, TCP and RFC 2217. Uses
 * {@link org.myrobotlab.service.sear.run}, {@link org.myrobotlab.service.sear.tcp}, and what these use. One thread per
 * export.
 */
package org.myrobotlab.service.sear.export;
