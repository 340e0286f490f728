/**
 * The window: reads snapshots, sends commands, and nothing waits for it. May use {@link org.SEAR.simulator} and below. jMonkeyEngine's thread
 * draws; on macOS in a process of its own.
 */
package org.SEAR.view;
