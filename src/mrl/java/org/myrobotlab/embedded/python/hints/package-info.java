// SPDX-License-Identifier: Apache-2.0
/**
 * Hints for scripts that are not valid Python 2.7, from their text alone: characters of word processors, unclosed
 * brackets and strings, wrong indentation, Python 3 and other languages. Does not use Jython.
 */
package org.myrobotlab.embedded.python.hints;
