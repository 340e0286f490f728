/**
 * The window: reads snapshots, sends commands, and nothing waits for it. Here is what opens it and its application; its parts are the packages
 * below. Uses {@link org.SEAR.view.hud}, {@link org.SEAR.view.platform}, {@link org.SEAR.view.process} and {@link org.SEAR.view.terrain}, and what
 * these use. jMonkeyEngine's thread draws; on macOS in a process of its own.
 */
package org.SEAR.view;
