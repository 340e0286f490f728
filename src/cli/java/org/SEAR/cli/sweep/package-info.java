// SPDX-License-Identifier: Apache-2.0
/**
 * {@code sear sweep}: starts the Python 3 package that distributes the runs with Dask, and runs Jython scripts in its
 * processes. Uses {@link org.myrobotlab.service}, {@link org.myrobotlab.embedded.python} and their dependencies. The
 * main thread.
 */
package org.SEAR.cli.sweep;
