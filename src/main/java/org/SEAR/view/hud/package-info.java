// SPDX-License-Identifier: Apache-2.0
/**
 * Text on the window (numbers, warnings, messages, help) and the picture of a camera. Uses {@link org.SEAR.view.input}
 * for the names of keys, {@link org.SEAR.view.link}, and their dependencies. Window thread only.
 */
package org.SEAR.view.hud;
