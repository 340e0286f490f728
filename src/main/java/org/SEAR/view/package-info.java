// SPDX-License-Identifier: Apache-2.0
/**
 * The window: reads snapshots and sends commands; the simulation never waits for it. This package opens the window and
 * contains its application. Uses {@link org.SEAR.view.hud}, {@link org.SEAR.view.platform},
 * {@link org.SEAR.view.process}, {@link org.SEAR.view.terrain} and their dependencies. jMonkeyEngine's thread draws, in
 * the window's own process.
 */
package org.SEAR.view;
