// SPDX-License-Identifier: Apache-2.0
/**
 * Network cameras for external programs. Uses {@link org.myrobotlab.service.sear.readings},
 * {@link org.myrobotlab.service.sear.tcp}, and what these use. Two threads per camera: one serves all clients without
 * waiting for them or the simulation, the other makes pictures.
 */
package org.myrobotlab.service.sear.netcam;
