// SPDX-License-Identifier: Apache-2.0
/**
 * Projects in one file, {@code NAME.sear}: rules for the content, reading of untrusted bundles, and writing. Uses
 * {@link org.SEAR.project} and its dependencies. Any thread, one operation at a time per folder.
 */
package org.SEAR.project.bundle;
