// SPDX-License-Identifier: Apache-2.0
/**
 * Partial reading of files, and TIFF: tags, and unpacking of strips and tiles. Every value of a file is checked before
 * use. Uses {@link org.SEAR.files} and its dependencies. Any thread, but only one at a time per file.
 */
package org.SEAR.terrain.tiff;
