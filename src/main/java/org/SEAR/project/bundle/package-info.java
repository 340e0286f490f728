/**
 * Projects in one file, {@code NAME.sear}: what a bundle may hold, reading it without trust, writing it. May use the other packages of
 * {@link org.SEAR.project}; nothing of them uses this one. Any thread, one at a time for a folder.
 */
package org.SEAR.project.bundle;
