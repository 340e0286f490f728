/**
 * The door for Python 3 programs, and what these ask about Java's objects. Uses {@link org.SEAR.grammar}. Py4J's threads carry out what programs
 * call, one for each thread of a program.
 */
package org.myrobotlab.service.sear.python3;
