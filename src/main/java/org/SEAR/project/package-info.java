/**
 * SEARproject on disk: its folder's layout, reading it whole, writing single objects, replacing it so that no crash loses it, the named beams. May
 * use {@link org.SEAR.geometry}, {@link org.SEAR.project.xml}, {@link org.SEAR.project.models}, {@link org.SEAR.project.problems} and the object
 * grammar. Any thread; what replaces a project holds a lock on its folder.
 */
package org.SEAR.project;
