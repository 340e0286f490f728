/**
 * One object, one XML file: strict reading and stable writing by the tables of the object grammar. Uses {@link org.SEAR.POJOs} and
 * {@link org.SEAR.project.problems}, and what these use. It knows no folders. Any thread.
 */
package org.SEAR.project.xml;
