/**
 * Keys and mouse, and what they mean. May use {@link org.SEAR.view.scene}, whose camera they turn. On the window's thread only.
 */
package org.SEAR.view.input;
