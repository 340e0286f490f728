/**
 * The words on the window: numbers, warnings, messages, help. Uses {@link org.SEAR.view.input}, and what that uses. It takes the names of keys from
 * there. On the window's thread only.
 */
package org.SEAR.view.hud;
