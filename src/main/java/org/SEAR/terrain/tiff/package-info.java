/**
 * Bytes of files of which a part is read, and TIFF: its tags, and its strips and tiles unpacked. Nothing in a file is believed before it is checked.
 * Uses {@link org.SEAR.files}, and what that uses. Any thread, but one file is read by one at a time.
 */
package org.SEAR.terrain.tiff;
