/**
 * Projects in one file, {@code NAME.sear}: what a bundle may hold, reading it without trust, writing it. Uses {@link org.SEAR.project}, and what
 * that uses. Any thread, one at a time for a folder.
 */
package org.SEAR.project.bundle;
