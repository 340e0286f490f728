/**
 * Files that a project brings along or that come with SEAR: finding them, how large they may be, whether a picture is whole; and pictures that are
 * drawn when they are asked for. Uses no other package of SEAR. Any thread.
 */
package org.SEAR.files;
