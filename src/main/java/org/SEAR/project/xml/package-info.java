/**
 * One object, one XML file: strict reading and stable writing by the tables of the object grammar. May use {@link org.SEAR.project.problems} and the
 * grammar, and knows no folders. Any thread.
 */
package org.SEAR.project.xml;
