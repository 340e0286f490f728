/**
 * The words on the window: numbers, warnings, messages, help. May use {@link org.SEAR.view.input} for the names of keys, {@link org.SEAR.view.scene}
 * for materials, and below. On the window's thread only.
 */
package org.SEAR.view.hud;
