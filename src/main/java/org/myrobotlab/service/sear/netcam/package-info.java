/**
 * Network cameras for external programs. Uses {@link org.myrobotlab.service.sear.readings}, and what that uses. Two
 * threads per camera: one serves all clients without waiting for them or the simulation, the other makes pictures.
 */
package org.myrobotlab.service.sear.netcam;
