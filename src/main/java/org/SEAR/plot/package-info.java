// SPDX-License-Identifier: Apache-2.0
/**
 * Drawings as PNG and SVG files, and plots of numbers with axes, titles and units. Uses {@link org.SEAR.files}. No
 * threads of its own.
 */
package org.SEAR.plot;
