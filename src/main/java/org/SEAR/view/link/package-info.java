/**
 * What the window knows of the simulation, and its commands. Uses {@link org.SEAR.scene}, and what that uses. Called on the window's thread; what it
 * hands out is immutable.
 */
package org.SEAR.view.link;
