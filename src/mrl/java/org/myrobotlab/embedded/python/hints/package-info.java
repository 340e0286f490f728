/**
 * What is wrong with a script that is no Python, found in its text, without Jython: characters from word processors, brackets and texts that are left
 * open, blanks at the beginning of lines, words of today's Python and of other languages.
 */
package org.myrobotlab.embedded.python.hints;
