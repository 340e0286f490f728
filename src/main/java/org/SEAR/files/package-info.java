// SPDX-License-Identifier: Apache-2.0
/**
 * Files of a project and files that come with SEAR: lookup, size limits, completeness of pictures, and pictures
 * generated on request; writing of files, whole or not at all; their text, made safe for a terminal. Uses no other
 * package of SEAR. Any thread.
 */
package org.SEAR.files;
