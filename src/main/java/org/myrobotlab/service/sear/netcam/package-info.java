/**
 * Cameras as network cameras, for programs outside. Uses {@link org.myrobotlab.service.sear.readings}, and what that uses. Two threads for each: one
 * serves all clients and never waits for one of them, nor for the simulation; the other has pictures made.
 */
package org.myrobotlab.service.sear.netcam;
