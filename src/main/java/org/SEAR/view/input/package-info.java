// SPDX-License-Identifier: Apache-2.0
/**
 * Keys and mouse and their commands. Uses {@link org.SEAR.view.scene}, whose camera the keys move, and its
 * dependencies. Window thread only.
 */
package org.SEAR.view.input;
