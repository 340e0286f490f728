/**
 * The words on the window, and the picture of a camera: numbers, warnings, messages, help. Uses {@link org.SEAR.view.input} and
 * {@link org.SEAR.view.link}, and what these use. It takes the names of keys from the first. On the window's thread only.
 */
package org.SEAR.view.hud;
