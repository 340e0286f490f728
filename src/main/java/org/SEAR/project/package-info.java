/**
 * SEARproject on disk: its folder's layout, reading it whole, writing single objects, replacing it so that no crash loses it, the named beams. Uses
 * {@link org.SEAR.project.models}, {@link org.SEAR.project.wiring} and {@link org.SEAR.terrain}, and what these use. Any thread; what replaces a
 * project holds a lock on its folder.
 */
package org.SEAR.project;
