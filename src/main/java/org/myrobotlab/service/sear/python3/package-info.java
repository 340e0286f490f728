// SPDX-License-Identifier: Apache-2.0
/**
 * The gateway for Python 3 programs, and their queries about Java objects. Uses {@link org.SEAR.grammar}
 * and {@link org.myrobotlab.service.sear.tcp}. Py4J's threads run the calls, one per thread of a program.
 */
package org.myrobotlab.service.sear.python3;
