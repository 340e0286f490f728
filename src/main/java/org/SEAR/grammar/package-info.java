/**
 * How the parameters of objects are described, checked, read and documented: what stands at a field says all of it. Knows no object. Uses
 * {@link org.SEAR.protocol.lidar}, and what that uses. Any thread.
 */
package org.SEAR.grammar;
