/**
 * The models of LIDARs that can be simulated, as data: what each measures, and which protocol it speaks. Knows nothing of the simulation. Uses no
 * other package of SEAR. Immutable, any thread.
 */
package org.SEAR.protocol.lidar;
