/**
 * What the window knows of the simulation: the world at one moment, the commands, and the words and beams made of the sensors' readings. Uses
 * {@link org.SEAR.simulator}, and what that uses. Called on the window's thread; what it hands out is immutable.
 */
package org.SEAR.view.link;
