/**
 * The window: reads snapshots, sends commands, and nothing waits for it. Here is what opens it and its application; its parts are the packages
 * below. May use them, {@link org.SEAR.simulator} and below. jMonkeyEngine's thread draws; on macOS in a process of its own.
 */
package org.SEAR.view;
