/**
 * Keys and mouse, and what they mean. Uses {@link org.SEAR.view.scene}, and what that uses. The keys turn its camera. On the window's thread only.
 */
package org.SEAR.view.input;
