/**
 * How the parameters of objects are described, checked, read and documented: what stands at a field says all of it. Knows no object. May use
 * {@link org.SEAR.protocol.lidar}. Any thread.
 */
package org.SEAR.grammar;
